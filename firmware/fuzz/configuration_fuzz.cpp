// Any bytes as a configuration, its overrides (lines after a line "--set"), and a target file: refused with a message,
// or checked values.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/config.h"
#include "config/target_file.h"
#include "values/assert.h"

namespace {

constexpr std::string_view kOverridesFrom = "\n--set\n";

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return lines;
}

void check_config(std::string_view text, const std::vector<std::string>& overrides) {
  const tripoint::Result<tripoint::Config> config = tripoint::parse_config(text, "demo.toml", overrides);
  if (!config) {
    TRIPOINT_ASSERT(!config.error().message.empty());
    return;
  }
  TRIPOINT_ASSERT(config->id != 0);
  TRIPOINT_ASSERT((config->volume.min_mm.array() < config->volume.max_mm.array()).all());
  TRIPOINT_ASSERT(!tripoint::canonical_text(*config, tripoint::kSetupTables).empty());
}

void check_target(std::string_view text) {
  const tripoint::Result<tripoint::TargetFile> target = tripoint::parse_target(text, "target.toml");
  if (!target) {
    TRIPOINT_ASSERT(!target.error().message.empty());
    return;
  }
  TRIPOINT_ASSERT(target->points.size() + target->tags.size() >= 1);
  TRIPOINT_ASSERT(target->points.size() <= 12 && target->tags.size() <= 12);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t marker = text.find(kOverridesFrom);
  const bool has_overrides = marker != std::string_view::npos;
  check_config(text.substr(0, marker),
               lines_of(has_overrides ? text.substr(marker + kOverridesFrom.size()) : std::string_view{}));
  check_target(text);
  return 0;
}
