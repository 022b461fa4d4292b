// `tripointd run`: measure and serve until a signal says stop.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tripoint {

/// @return 0 after SIGINT or SIGTERM; 2 for a wrong configuration or a port in use
int run_command(const std::filesystem::path& config_file, const std::vector<std::string>& overrides);

/// `tripointd check-config`: says whether `run` would start with this file.
int check_config_command(const std::filesystem::path& config_file, const std::vector<std::string>& overrides);

}  // namespace tripoint
