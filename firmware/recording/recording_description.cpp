#include "recording/recording_description.h"

#include <string>

#include "document/table_reader.h"
#include "document/toml_tree.h"

namespace tripoint {
namespace {

constexpr std::int64_t kMaxSide_px = 4096;
constexpr double kMaxLineTime_us = 1000.0;  // a picture of 720 rows would take 0.7 s

RecordedFormat format_of(TableReader& table) {
  return table.choice<RecordedFormat>(
      "pixel_format", {{"jpg", RecordedFormat::kJpg}, {"yuyv", RecordedFormat::kYuyv}, {"png", RecordedFormat::kPng}});
}

}  // namespace

Result<RecordingDescription> recording_description_from(std::string_view toml, std::string_view file_name) {
  const Result<TomlTable> tree = toml_tree_from(toml, file_name);
  if (!tree) return tl::make_unexpected(tree.error());
  Findings findings{std::string(file_name)};
  TableReader table(findings, *tree);
  table.choice<int>("format", {{"tripoint-recording/1", 1}});
  RecordingDescription description;
  description.format = format_of(table);
  description.size.width_px = static_cast<int>(table.integer("width_px", {16, kMaxSide_px}));
  description.size.height_px = static_cast<int>(table.integer("height_px", {16, kMaxSide_px}));
  description.line_time = duration_from_seconds(table.number("line_time_us", {0.0, kMaxLineTime_us}, 0.0) * 1e-6);
  description.utc_offset = Duration{table.integer("utc_offset_ns", {}, 0)};
  if (description.format == RecordedFormat::kYuyv && description.size.width_px % 2 != 0) {
    table.refuse("width_px", "yuyv has pairs of pixels, so it must be even");
  }
  table.finish();
  if (findings.error()) return tl::make_unexpected(*findings.error());
  return description;
}

}  // namespace tripoint
