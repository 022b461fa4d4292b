// `tripointd expose --config FILE`: finds exposure and gain for measuring, and writes them where it was asked to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tripoint {

struct ExposeOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<int> gain = {};  ///< nothing: the lowest that is enough
  bool write = false;
  bool json = false;
};

/// Looks at the target at the near and at the far end of the working volume. An operator holds it there and presses
/// Enter; simulated cameras see it held there.
///
/// @return 0; 1 when nothing suits or the check in a fresh picture fails; 3 when a camera is missing, in use, or stops
///   in the middle; otherwise as report()
int expose_command(const ExposeOptions& options);

}  // namespace tripoint
