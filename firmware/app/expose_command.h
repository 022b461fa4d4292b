// `tripointd expose --config FILE`: finds the exposure for measuring, and writes it where it was asked to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tripoint {

struct ExposeOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  bool write = false;
  bool json = false;
};

/// Looks at the target at the near and at the far end of the working volume. An operator holds it there and presses
/// Enter; simulated cameras see it held there.
///
/// @return 0; 1 when no exposure suits or the check in a fresh picture fails; otherwise as report()
int expose_command(const ExposeOptions& options);

}  // namespace tripoint
