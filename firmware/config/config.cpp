#include "config/config.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "config/tables.h"
#include "document/file.h"
#include "document/sha256.h"
#include "document/table_reader.h"
#include "document/toml_tree.h"

namespace tripoint {
namespace {

Result<TomlTable> tree_from(std::string_view text, std::string_view file_name, std::span<const std::string> overrides) {
  Result<TomlTable> tree = toml_tree_from(text, file_name);
  for (const std::string& assignment : overrides) {
    if (tree) tree = with_override(*std::move(tree), assignment);
  }
  return tree;
}

/// A table with one key, which names a file.
std::filesystem::path file_from(TableReader table, const std::filesystem::path& folder) {
  std::filesystem::path file = path_from(folder, table.text("file", ""));
  table.finish();
  return file;
}

Config config_from(TableReader& root, const std::filesystem::path& folder) {
  Config config;
  config.cameras = cameras_from(root.table("cameras"));
  config.calibration_file = file_from(root.table("calibration"), folder);
  config.recording = recording_from(root.table("recording"), folder, config.cameras.source);
  config.detector = detector_from(root.table("detector"));
  if (config.cameras.format == ConfiguredFormat::kGrey && config.detector.kind != ConfiguredDetector::kAprilTag) {
    root.table("cameras").refuse("format",
                                 "red LEDs and spheres cannot be told from other things without colour: permitted "
                                 "is \"yuyv\" or \"mjpeg\"");
  }
  config.target_file = file_from(root.table("target"), folder);
  config.volume = volume_from(root.table("volume"));
  config.timing = timing_from(root.table("timing"));
  config.output = output_from(root.table("output"));
  config.modulation = modulation_from(root.table("modulation"), config);
  config.datum = datum_from(root, config);
  config.modbus = modbus_from(root.table("modbus"));
  config.simulation = simulation_from(root.table("simulation"), folder);
  if (config.simulation.led_lines != SimulatedLines::kWorking && !config.modulation.enabled) {
    root.table("simulation")
        .refuse("led_lines", "there are no lines without modulation.enabled = true: permitted is \"working\"");
  }
  root.finish();
  return config;
}

constexpr std::string_view kMeasuresNothing = "cameras.calibrating.";

std::string joined(std::span<const std::string> lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

std::filesystem::path path_from(const std::filesystem::path& folder, const std::string& written) {
  return written.empty() ? std::filesystem::path{} : (folder / written).lexically_normal();
}

Result<Config> parse_config(std::string_view text, std::string_view file_name, std::span<const std::string> overrides) {
  const Result<TomlTable> tree = tree_from(text, file_name, overrides);
  if (!tree) return tl::make_unexpected(tree.error());
  Findings findings{std::string{file_name}};
  TableReader root{findings, *tree};
  Config config = config_from(root, std::filesystem::path{file_name}.parent_path());
  if (findings.error()) return tl::make_unexpected(*findings.error());
  config.values = findings.values();
  config.places = findings.places();
  config.id = id_from(sha256(joined(config.values)));
  return config;
}

Result<Config> load_config(const std::filesystem::path& path, std::span<const std::string> overrides) {
  const Result<std::string> text = read_file(path, kMostDocumentBytes);
  if (!text) return tl::make_unexpected(text.error());
  return parse_config(*text, path.string(), overrides);
}

Error named_by(const Config& config, std::string_view key, const Error& error) {
  const auto found =
      std::find_if(config.places.begin(), config.places.end(), [key](const auto& place) { return place.first == key; });
  const std::string place = found != config.places.end() ? found->second + ": " : "";
  return {error.code, fmt::format("{}{}: {}", place, key, error.message)};
}

std::string canonical_text(const Config& config, std::span<const std::string_view> tables) {
  std::vector<std::string> lines;
  std::copy_if(config.values.begin(), config.values.end(), std::back_inserter(lines), [&](const std::string& line) {
    const std::string_view table = std::string_view{line}.substr(0, line.find('.'));
    return !line.starts_with(kMeasuresNothing) && std::find(tables.begin(), tables.end(), table) != tables.end();
  });
  return joined(lines);
}

}  // namespace tripoint
