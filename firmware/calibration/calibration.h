// A calibration file as a checked value: what it says can be used without further questions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/sha256.h"
#include "document/toml_tree.h"
#include "geometry/rig.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// A length measured with this calibration that is known from elsewhere.
struct LengthCheck {
  double nominal_mm = 0.0;
  double measured_mm = 0.0;
  double uncertainty_mm = 0.0;  ///< k = 2, of the comparison
};

struct Calibration {
  StereoCalibration stereo;
  std::optional<RigCovariance> covariance;  ///< symmetric, positive semidefinite
  PerSide<std::string> serial;              ///< "" = the camera has none: then the port binds
  PerSide<std::string> port;
  std::vector<LengthCheck> lengths;
  std::optional<UtcSecond> created;
  std::uint32_t id = 0;  ///< registers 14-15
  Sha256 sha256{};       ///< of the whole file
};

/// There is a length check, and each agrees within its uncertainty. An uncertainty of more than a hundredth of the
/// length proves nothing. Status bit 13.
bool verified_by_length(const Calibration& calibration);

/// Reads format "tripoint-calibration/1". [quality] may hold further keys; everywhere else an unknown key is an error.
///
/// @return kMalformed   no TOML, another format, or integrity.sha256 does not fit the bytes before "[integrity]"
///         kUnknownKey, kMissingKey, kOutOfRange   naming file, line, key and what is permitted; kOutOfRange as well
///                      when rig_of refuses the two cameras
Result<Calibration> parse_calibration(std::string_view text, std::string_view file_name);

/// @return kCannotRead, or as parse_calibration
Result<Calibration> load_calibration(const std::filesystem::path& path);

}  // namespace tripoint
