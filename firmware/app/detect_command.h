// `tripointd detect IMAGE... --json`: what the detector finds in picture files.
#pragma once

#include <filesystem>
#include <vector>

#include "line/detect/settings.h"

namespace tripoint {

/// Prints one JSON line for each image: its points, or why it cannot be read.
///
/// @return 0, or 2 when any image could not be decoded
int detect_command(const std::vector<std::filesystem::path>& images, const LedDetectorSettings& settings);

}  // namespace tripoint
