#include "app/expose_command.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "app/calibrating_exposure.h"
#include "app/camera_pair.h"
#include "app/camera_supply.h"
#include "app/exit_code.h"
#include "app/exposure_sight.h"
#include "app/unit_setup.h"
#include "config/target_file.h"
#include "devices/system_clock.h"
#include "line/detect/exposure_margin.h"

namespace tripoint {
namespace {

using nlohmann::ordered_json;

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

/// One finding of the setting `measuring`.
class Exposing {
 public:
  Exposing(const ExposeOptions& options, const Config& config, std::size_t leds, const CamerasAt& cameras)
      : options_(options), config_(config), leds_(leds), cameras_(cameras) {}

  int run() {
    Result<ExposureOffer> offered = offer();
    if (!offered) return report(offered.error());
    Result<PlaceBounds> near_end =
        at(End::kNear, *offered, {config_.cameras.measuring.exposure, offered->gains.lowest});
    if (!near_end) return refused(near_end.error());
    const Result<PlaceBounds> far_end = at(End::kFar, *offered, near_end->look.setting);
    if (!far_end) return refused(far_end.error());
    if (far_end->look.setting.gain != near_end->look.setting.gain) {
      const Result<ExposureSetting> alone = exposure_for(*far_end, *far_end, *offered);
      if (!alone) return refused(alone.error());  // before anyone goes back to the near end
      offered->gains = {far_end->look.setting.gain, far_end->look.setting.gain, 1};
      near_end = at(End::kNear, *offered, far_end->look.setting);
      if (!near_end) return refused(near_end.error());
    }
    const Result<ExposureSetting> chosen = exposure_for(*near_end, *far_end, *offered);
    if (!chosen) return refused(chosen.error());
    const Result<Look> check = look_at(*chosen);  // the target still is where it was last
    if (!check) return report(check.error());
    if (!suits(*check)) {
      return refused(
          {ErrorCode::kOutOfRange,
           fmt::format("{} us with gain {} was chosen, but checked in a fresh picture it gives {}, {}; was the target "
                       "moved?",
                       check->setting.exposure.count(), check->setting.gain, words(*check, Side::kLeft),
                       words(*check, Side::kRight))});
    }
    return conclude(check->setting, *near_end, *far_end);
  }

 private:
  [[nodiscard]] double z_mm() const {
    return end_ == End::kNear ? config_.volume.min_mm.z() : config_.volume.max_mm.z();
  }

  Result<ExposureOffer> offer() {
    return opened(config_.cameras.measuring).and_then([&](const CameraPair& cameras) {
      return offer_with_gain(cameras.offered(), options_.gain);
    });
  }

  Result<CameraPair> opened(const ExposureSetting& setting) {
    return CameraPair::open(
        config_, [this](const Config& wanted) { return cameras_(wanted, z_mm()); }, setting);
  }

  Result<PlaceBounds> at(End end, const ExposureOffer& offered, const ExposureSetting& start) {
    end_ = end;
    ++step_;
    if (const Result<void> placed = placed_by_operator(); !placed) return tl::make_unexpected(placed.error());
    return bounds_at_place([this](const ExposureSetting& setting) { return look_at(setting); }, offered, start);
  }

  /// Asks for the target to be held there, and waits for Enter.
  Result<void> placed_by_operator() {
    if (config_.cameras.source == CameraSource::kSimulation) return {};
    const std::string which =
        step_ <= 2 ? fmt::format("Step {} of 2", step_) : "Once more, because the far end needs a higher gain";
    return asked(
        fmt::format("{}: hold the target at the {} end of the working volume (z = {:.0f} mm), LEDs on and towards the "
                    "cameras; press "
                    "Enter, and keep it still until the next line that asks for something.",
                    which, name(end_), z_mm()));
  }

  Result<Look> look_at(const ExposureSetting& setting) {
    Result<Look> look = opened(setting).and_then(
        [&](const CameraPair& cameras) { return look_at_leds(cameras, config_.detector, leds_); });
    if (look) show(*look);
    return look;
  }

  void show(const Look& look) const {
    if (options_.json) {
      const ordered_json line = {{"end", name(end_)},
                                 {"exposure_us", look.setting.exposure.count()},
                                 {"gain", look.setting.gain},
                                 {"left", json_of(look, Side::kLeft)},
                                 {"right", json_of(look, Side::kRight)}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("{:<4} end, {:>6} us, gain {}: {}, {}\n", name(end_), look.setting.exposure.count(), look.setting.gain,
                 words(look, Side::kLeft), words(look, Side::kRight));
      std::fflush(stdout);  // someone waits with a target in hand
    }
  }

  int conclude(const ExposureSetting& chosen, const PlaceBounds& near_end, const PlaceBounds& far_end) {
    const std::vector<ConfigEdit> edits = edits_of("cameras", chosen);
    if (const Result<void> written = written_where_asked(options_, edits); !written) return report(written.error());
    const auto exposure_us = static_cast<double>(chosen.exposure.count());
    const double brightest = kRecommendedTo * exposure_us / near_end.longest_us;
    const double dimmest = kRecommendedFrom * exposure_us / far_end.shortest_us;
    if (options_.json) {
      const ordered_json line = {{"setting", "measuring"},
                                 {"exposure_us", chosen.exposure.count()},
                                 {"gain", chosen.gain},
                                 {"near_brightest", rounded(brightest)},
                                 {"far_dimmest", rounded(dimmest)},
                                 {"checked_at", name(end_)},
                                 {"written", options_.write}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print(
          "measuring: {} us, gain {}; checked at the {} end; brightest at the near end {:.2f}, dimmest at the far end "
          "{:.2f} x clip\n{}",
          chosen.exposure.count(), chosen.gain, name(end_), brightest, dimmest, written_text(options_, edits));
    }
    return number(ExitCode::kWell);
  }

  const ExposeOptions& options_;
  const Config& config_;
  std::size_t leds_;
  const CamerasAt& cameras_;
  End end_ = End::kNear;
  int step_ = 0;  ///< times that someone was asked to hold the target
};

/// The target's, and the datum.
Result<std::size_t> leds_in_sight(const Config& config) {
  const std::size_t beside = config.datum ? 1 : 0;
  if (config.target_file.empty()) return 1 + beside;
  return load_target(config.target_file)
      .map_error([&](const Error& error) { return named_by(config, "target.file", error); })
      .map([beside](const TargetFile& target) { return target.points.size() + beside; });
}

}  // namespace

int expose_for_measuring(const ExposeOptions& options, const Config& config, std::size_t leds,
                         const CamerasAt& cameras) {
  return Exposing(options, config, leds, cameras).run();
}

int expose_command(const ExposeOptions& options) {
  const Result<Config> config = load_config(options.config, options.overrides);
  if (!config) return report(config.error());
  if (config->cameras.source == CameraSource::kRecording) {
    return report({ErrorCode::kMismatch, "cameras.source is \"recording\": its exposure was chosen when it was made"});
  }
  if (options.write) {  // before anyone is asked to hold something
    if (const auto file = editable_file(options.config); !file) return report(file.error());
  }
  if (options.purpose == ExposeFor::kCalibrating) return expose_for_calibrating(options, *config);
  if (config->detector.kind != ConfiguredDetector::kLed) {
    return report(
        named_by(*config, "detector.kind",
                 {ErrorCode::kMismatch, "the exposure for measuring is found by LEDs: to expose set \"led\""}));
  }
  const Result<std::size_t> leds = leds_in_sight(*config);
  if (!leds) return report(leds.error());
  const SystemClock clock;
  return expose_for_measuring(options, *config, *leds, [&clock](const Config& wanted, double z_mm) {
    return wanted.cameras.source == CameraSource::kSimulation
               ? simulated_cameras_showing(wanted, clock, Vec3(0.0, 0.0, z_mm))
               : camera_supply(wanted, MeasuredTarget{}, clock);
  });
}

}  // namespace tripoint
