#include "devices/exposure_stamp.h"

namespace tripoint {

TimePoint middle_of_exposure(TimePoint stamp, const StampTiming& timing) {
  const TimePoint moment = stamp - timing.latency;
  switch (timing.point) {
    case StampPoint::kStartOfExposure:
      return moment + timing.exposure / 2;
    case StampPoint::kFirstByte:
      break;
  }
  return moment - timing.exposure / 2;
}

}  // namespace tripoint
