// Any bytes as a calibration file: refused with a message, or a calibration that has a rig.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "calibration/calibration.h"
#include "values/assert.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const tripoint::Result<tripoint::Calibration> calibration = tripoint::parse_calibration(text, "calibration.toml");
  if (!calibration) {
    TRIPOINT_ASSERT(!calibration.error().message.empty());
    return 0;
  }
  TRIPOINT_ASSERT(calibration->id != 0);
  TRIPOINT_ASSERT(tripoint::rig_of(calibration->stereo).has_value());
  TRIPOINT_ASSERT(!calibration->covariance || calibration->covariance->allFinite());
  static_cast<void>(tripoint::verified_by_length(*calibration));
  return 0;
}
