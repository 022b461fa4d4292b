#include "app/exposing.h"

#include <fmt/core.h>

#include <cmath>
#include <iostream>

#include "app/exit_code.h"

namespace tripoint {

Result<ExposureOffer> offer_with_gain(const ExposureOffer& offered, std::optional<int> gain) {
  if (!gain) return offered;
  const GainRange& gains = offered.gains;
  const bool permitted = *gain >= gains.lowest && *gain <= gains.highest && (*gain - gains.lowest) % gains.step == 0;
  if (permitted) return ExposureOffer{offered.shortest, offered.longest, {*gain, *gain, 1}};
  return failure(ErrorCode::kOutOfRange, fmt::format("--gain {}: the cameras permit {} to {} in steps of {}", *gain,
                                                     gains.lowest, gains.highest, gains.step));
}

Result<void> asked(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  std::string line;
  if (std::getline(std::cin, line)) return {};
  return failure(ErrorCode::kCannotRead, "nobody pressed Enter: someone has to hold it there and say when");
}

int refused(const Error& error) {
  const int code = report(error);
  const bool verdict = error.code == ErrorCode::kOutOfRange || error.code == ErrorCode::kTimeout;
  return verdict ? number(ExitCode::kNo) : code;
}

std::vector<ConfigEdit> edits_of(const std::string& table, const ExposureSetting& setting) {
  return {{table, "exposure_us", setting.exposure.count()}, {table, "gain", setting.gain}};
}

Result<void> written_where_asked(const ExposeOptions& options, std::span<const ConfigEdit> edits) {
  return options.write ? edit_config_file(options.config, edits) : Result<void>{};
}

std::string written_text(const ExposeOptions& options, std::span<const ConfigEdit> edits) {
  return options.write ? fmt::format("written to {}\n", options.config.string())
                       : fmt::format("not written (--write does it); the lines are:\n{}", lines_of(edits));
}

double rounded(double level) { return std::round(1000.0 * level) / 1000.0; }

}  // namespace tripoint
