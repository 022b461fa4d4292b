// From a driver's time stamp to the middle of the exposure of row 0.
#pragma once

#include <cstdint>

#include "values/time.h"

namespace tripoint {

/// The moment that the driver's stamp stands for. The buffer's own flag (V4L2_BUF_FLAG_TSTAMP_SRC_SOE) says start of
/// exposure on every UVC camera and is not to be believed.
enum class StampPoint : std::uint8_t {
  kFirstByte,        ///< the frame's first packet came: row 0 has just been read out. uvcvideo's default
  kStartOfExposure,  ///< of row 0: uvcvideo with hwtimestamps=1, from the camera's own clock
};

/// @param exposure how long row 0 is exposed
TimePoint middle_of_exposure(TimePoint stamp, StampPoint point, Duration exposure);

}  // namespace tripoint
