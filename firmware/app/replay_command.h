// `tripointd replay FOLDER`: a recording through the same line, one JSON line for each verdict.
#pragma once

#include <filesystem>
#include <string>

namespace tripoint {

struct ReplayOptions {
  std::filesystem::path folder;
  std::filesystem::path calibration;
  std::filesystem::path target;  ///< empty: one LED at the target's origin
  std::filesystem::path config;  ///< empty: defaults, and no working volume
  std::string frame = "reference";
};

/// As fast as possible, in the order of the recording's rows.
///
/// Of frames that cannot be used the first is named and the rest are counted.
///
/// @return 0; 2 when a file is missing or wrong, or no frame at all could be used
int replay_command(const ReplayOptions& options);

}  // namespace tripoint
