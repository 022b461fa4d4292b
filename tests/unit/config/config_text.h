// A smallest configuration, and what parse_config says about one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/config.h"

namespace tripoint::testing {

inline constexpr std::string_view kSmallest = R"([cameras]
source = "simulation"
[volume]
min_mm = [-150, -150, 300]
max_mm = [150, 150, 600]
)";

inline Result<Config> config_with(const std::vector<std::string>& overrides) {
  return parse_config(kSmallest, "/etc/tripoint/demo.toml", overrides);
}

/// "" when the configuration is accepted.
inline std::string message_with(const std::vector<std::string>& overrides) {
  const Result<Config> config = config_with(overrides);
  return config ? "" : config.error().message;
}

inline std::string message_of(std::string_view text) {
  const Result<Config> config = parse_config(text, "demo.toml", {});
  return config ? "" : config.error().message;
}

}  // namespace tripoint::testing
