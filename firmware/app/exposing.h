// What finding an exposure takes besides looking: what the cameras offer, a person, and a file.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/camera_pair.h"
#include "config/edited_config.h"

namespace tripoint {

enum class ExposeFor { kMeasuring, kCalibrating };

struct ExposeOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  ExposeFor purpose = ExposeFor::kMeasuring;
  std::optional<int> gain = {};  ///< nothing: the lowest that is enough
  bool write = false;
  bool json = false;
};

/// What the cameras offer, of it only the gain that was asked for.
///
/// @return kOutOfRange, with what is permitted, for a gain that they do not have
Result<ExposureOffer> offer_with_gain(const ExposureOffer& offered, std::optional<int> gain);

/// Says to stderr what someone has to do, and waits for Enter.
///
/// @return kCannotRead when nobody can press it
Result<void> asked(const std::string& what);

/// How the program ends when the search did not: what was seen is a verdict, all else an error.
int refused(const Error& error);

/// "exposure_us" and "gain" of a table.
std::vector<ConfigEdit> edits_of(const std::string& table, const ExposureSetting& setting);

/// Writes the values into the file, if that was asked for.
///
/// @return errors of edit_config_file
Result<void> written_where_asked(const ExposeOptions& options, std::span<const ConfigEdit> edits);

/// Where they were written, or the lines to write.
std::string written_text(const ExposeOptions& options, std::span<const ConfigEdit> edits);

/// A level or a peak as JSON has it: three digits after the point.
double rounded(double level);

}  // namespace tripoint
