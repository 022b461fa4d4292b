// `tripointd detect IMAGE... --json`: what the detector finds in picture files.
#pragma once

#include <filesystem>
#include <vector>

namespace tripoint {

/// Prints one JSON line for each image: its points, or why it cannot be read.
///
/// @param config  gives [detector]; empty: the defaults
/// @return 0, or 2 when the configuration is wrong or any image could not be decoded
int detect_command(const std::vector<std::filesystem::path>& images, const std::filesystem::path& config);

}  // namespace tripoint
