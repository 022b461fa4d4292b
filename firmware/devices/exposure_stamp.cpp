#include "devices/exposure_stamp.h"

namespace tripoint {

TimePoint middle_of_exposure(TimePoint stamp, StampPoint point, Duration exposure) {
  return point == StampPoint::kStartOfExposure ? stamp + exposure / 2 : stamp - exposure / 2;
}

}  // namespace tripoint
