// `tripointd snapshot --config FILE --out FOLDER`: one picture of each camera, as they are wanted for calibrating.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tripoint {

struct SnapshotOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::filesystem::path out;
  bool json = false;
};

/// Writes FOLDER/left-STAMP.png and FOLDER/right-STAMP.png, both or none: the luma as the cameras gave it, exposed as
/// [cameras.calibrating] says. STAMP is the UTC at which the left one was exposed; the right one follows within two
/// frames. Simulated cameras see a board.
///
/// @return 0, with or without a board in the pictures; 3 when a camera is missing, in use, or stops; otherwise as
///   report(): 2 without [cameras.calibrating], or where a picture cannot be written
int snapshot_command(const SnapshotOptions& options);

}  // namespace tripoint
