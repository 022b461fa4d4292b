// `tripointd detect IMAGE... --json`: what the detector finds in picture files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tripoint {

struct DetectOptions {
  std::vector<std::filesystem::path> images;
  std::filesystem::path config;  ///< gives [detector]; empty: the defaults
  std::string
      detector;  ///< "led", "sphere" or "apriltag", by default values where [detector] is of another; empty: as there
  std::string family = "tag36h11";  ///< of AprilTags
  std::filesystem::path explain;    ///< folder for an image of each picture that shows why; empty: none
};

/// Prints one JSON line for each image: its points, or why it cannot be read. With `explain` also every candidate, and
/// where its image was written.
///
/// @return 0, or 2 when the configuration is wrong, any image could not be decoded or any explanation not be written
int detect_command(const DetectOptions& options);

}  // namespace tripoint
