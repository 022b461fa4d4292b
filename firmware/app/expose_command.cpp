#include "app/expose_command.h"

#include <fmt/core.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/camera_supply.h"
#include "app/exit_code.h"
#include "app/exposure_sight.h"
#include "app/unit_setup.h"
#include "config/edited_config.h"
#include "config/target_file.h"
#include "devices/system_clock.h"
#include "line/detect/exposure_margin.h"

namespace tripoint {
namespace {

using nlohmann::ordered_json;
using std::chrono::microseconds;

/// A factor: the brightest pixel of a small spot reads up to a quarter low just below clip (rendered at 320x240).
constexpr double kCheckTolerance = 1.3;

enum class End { kNear, kFar };
constexpr std::string_view name(End end) { return end == End::kNear ? "near" : "far"; }

std::string words(const Look& look, Side side) {
  const std::optional<SeenPeaks>& peaks = look.peaks[side];
  if (!peaks) return fmt::format("{} {} spots", name(side), look.spots[side]);
  if (peaks->dimmest == peaks->brightest) return fmt::format("{} {:.2f} x clip", name(side), peaks->brightest);
  return fmt::format("{} {:.2f} to {:.2f} x clip", name(side), peaks->dimmest, peaks->brightest);
}

double rounded(double peak) { return std::round(1000.0 * peak) / 1000.0; }

ordered_json json_of(const Look& look, Side side) {
  const std::optional<SeenPeaks>& peaks = look.peaks[side];
  if (!peaks) return nullptr;
  return {{"dimmest", rounded(peaks->dimmest)}, {"brightest", rounded(peaks->brightest)}};
}

bool suits(const Look& look) {
  for (const Side side : kBothSides) {
    const std::optional<SeenPeaks>& peaks = look.peaks[side];
    if (!peaks || peaks->dimmest * kCheckTolerance < kRecommendedFrom ||
        peaks->brightest > kRecommendedTo * kCheckTolerance) {
      return false;
    }
  }
  return true;
}

/// How the program ends when the search did not: what was seen is a verdict, all else an error.
int refused(const Error& error) {
  const int code = report(error);
  const bool verdict =
      error.code == ErrorCode::kOutOfRange || error.code == ErrorCode::kTimeout || error.code == ErrorCode::kMismatch;
  return verdict ? number(ExitCode::kNo) : code;
}

/// One finding of the setting `measuring`.
class Exposing {
 public:
  Exposing(const ExposeOptions& options, const Config& config, std::size_t leds)
      : options_(options),
        config_(config),
        sight_(
            config, [this](const Config& wanted) { return supply(wanted); }, leds) {}

  int run() {
    const Result<ExposureRange> offered = sight_.offered();
    if (!offered) return report(offered.error());
    const Result<PlaceBounds> near_end = at(End::kNear, *offered, config_.cameras.exposure);
    if (!near_end) return refused(near_end.error());
    const Result<PlaceBounds> far_end = at(End::kFar, *offered, near_end->look.exposure);
    if (!far_end) return refused(far_end.error());
    const Result<microseconds> chosen = exposure_for(*near_end, *far_end, *offered);
    if (!chosen) return refused(chosen.error());
    const Result<Look> check = look_at(*chosen);  // the target still is at the far end
    if (!check) return report(check.error());
    if (!suits(*check)) {
      return refused(
          {ErrorCode::kMismatch,
           fmt::format("{} us was chosen, but checked in a fresh picture it gives {}, {}; was the target moved?",
                       check->exposure.count(), words(*check, Side::kLeft), words(*check, Side::kRight))});
    }
    return conclude(check->exposure, *near_end);
  }

 private:
  Result<PerSide<OpenCamera>> supply(const Config& config) {
    if (config.cameras.source != CameraSource::kSimulation) return camera_supply(config, clock_);
    const double z_mm = end_ == End::kNear ? config.volume.min_mm.z() : config.volume.max_mm.z();
    return simulated_cameras_showing(config, clock_, Vec3(0.0, 0.0, z_mm));
  }

  Result<PlaceBounds> at(End end, const ExposureRange& offered, microseconds start) {
    end_ = end;
    if (const Result<void> placed = placed_by_operator(); !placed) return tl::make_unexpected(placed.error());
    return bounds_at_place([this](microseconds exposure) { return look_at(exposure); }, offered, start);
  }

  /// Asks for the target to be held there, and waits for Enter.
  Result<void> placed_by_operator() {
    if (config_.cameras.source == CameraSource::kSimulation) return {};
    const double z_mm = end_ == End::kNear ? config_.volume.min_mm.z() : config_.volume.max_mm.z();
    fmt::print(stderr,
               "Hold the target still at the {} end of the working volume (z = {:.0f} mm), LEDs on and towards "
               "the cameras, then press Enter.\n",
               name(end_), z_mm);
    std::string line;
    if (std::getline(std::cin, line)) return {};
    return failure(ErrorCode::kTimeout, "nobody pressed Enter: someone has to hold the target and say when");
  }

  Result<Look> look_at(microseconds exposure) {
    Result<Look> look = sight_.look(exposure);
    if (look) show(*look);
    return look;
  }

  void show(const Look& look) const {
    if (options_.json) {
      const ordered_json line = {{"end", name(end_)},
                                 {"exposure_us", look.exposure.count()},
                                 {"left", json_of(look, Side::kLeft)},
                                 {"right", json_of(look, Side::kRight)}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("{:<4} end, {:>6} us: {}, {}\n", name(end_), look.exposure.count(), words(look, Side::kLeft),
                 words(look, Side::kRight));
    }
  }

  int conclude(microseconds exposure, const PlaceBounds& near_end) {
    const std::array<ConfigEdit, 2> edits{
        {{"cameras", "exposure_us", exposure.count()}, {"cameras", "gain", config_.cameras.gain}}};
    if (options_.write) {
      if (const Result<void> written = edit_config_file(options_.config, edits); !written) {
        return report(written.error());
      }
    }
    const double near_peak = kRecommendedTo * static_cast<double>(exposure.count()) / near_end.longest_us;
    if (options_.json) {
      const ordered_json line = {{"setting", "measuring"},
                                 {"exposure_us", exposure.count()},
                                 {"gain", config_.cameras.gain},
                                 {"near_brightest", rounded(near_peak)},
                                 {"written", options_.write}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print(
          "measuring: {} us, gain {}; checked at the far end; at the near end the brightest is {:.2f} x clip\n{}",
          exposure.count(), config_.cameras.gain, near_peak,
          options_.write ? fmt::format("written to {}\n", options_.config.string())
                         : fmt::format("not written (--write does it); the lines are:\n{}", lines_of(edits)));
    }
    return number(ExitCode::kWell);
  }

  const ExposeOptions& options_;
  const Config& config_;
  SystemClock clock_;
  ExposureSight sight_;
  End end_ = End::kNear;
};

Result<std::size_t> leds_of_target(const Config& config) {
  if (config.target_file.empty()) return std::size_t{1};
  return load_target(config.target_file)
      .map_error([&](const Error& error) { return named_by(config, "target.file", error); })
      .map([](const TargetFile& target) { return target.points.size(); });
}

}  // namespace

int expose_command(const ExposeOptions& options) {
  const Result<Config> config = load_config(options.config, options.overrides);
  if (!config) return report(config.error());
  if (config->cameras.source == CameraSource::kRecording) {
    return report({ErrorCode::kMismatch, "cameras.source is \"recording\": its exposure was chosen when it was made"});
  }
  if (const Result<void> detector = check_detector(*config); !detector) return report(detector.error());
  if (options.write) {  // before anyone is asked to hold a target
    if (const auto file = editable_file(options.config); !file) return report(file.error());
  }
  const Result<std::size_t> leds = leds_of_target(*config);
  if (!leds) return report(leds.error());
  return Exposing(options, *config, *leds).run();
}

}  // namespace tripoint
