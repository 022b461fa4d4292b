#include "app/calibrating_exposure.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/board_look.h"
#include "app/board_search.h"
#include "app/camera_supply.h"
#include "app/exit_code.h"
#include "devices/system_clock.h"

namespace tripoint {
namespace {

using nlohmann::ordered_json;

std::string words(const BoardLook& look, Side side) {
  const std::optional<BoardLevels>& levels = look.board[side].levels;
  if (!levels) return fmt::format("{} no board", name(side));
  return fmt::format("{} white {:.0f} %, black {:.0f} %", name(side), 100.0 * levels->white, 100.0 * levels->black);
}

ordered_json json_of(const BoardLook& look, Side side) {
  const std::optional<BoardLevels>& levels = look.board[side].levels;
  if (!levels) return nullptr;
  return {{"white", rounded(levels->white)}, {"black", rounded(levels->black)}};
}

/// One finding of the setting `calibrating`.
class Exposing {
 public:
  Exposing(const ExposeOptions& options, const Config& config) : options_(options), config_(config) {}

  int run() {
    const ExposureSetting known = config_.cameras.calibrating.value_or(config_.cameras.measuring);
    const Result<ExposureOffer> offered = opened(known).and_then(
        [&](const CameraPair& cameras) { return offer_with_gain(cameras.offered(), options_.gain); });
    if (!offered) return report(offered.error());
    if (const Result<void> held = held_by_operator(); !held) return report(held.error());
    const Result<BoardLook> found =
        search_for_board([this](const ExposureSetting& setting) { return look_at(setting); }, *offered,
                         {known.exposure, offered->gains.lowest});
    if (!found) return refused(found.error());
    const Result<BoardLook> fresh = look_at(found->setting);
    if (!fresh) return report(fresh.error());
    if (const Result<void> checked = check_board(*fresh, *offered); !checked) {
      return refused({checked.error().code, fmt::format("{}; it was well in the picture before: was the board moved?",
                                                        checked.error().message)});
    }
    return conclude(*fresh);
  }

 private:
  Result<CameraPair> opened(const ExposureSetting& setting) {
    return CameraPair::open(
        config_, [this](const Config& wanted) { return cameras_before_board(wanted, clock_); }, setting);
  }

  [[nodiscard]] Result<void> held_by_operator() const {
    if (config_.cameras.source == CameraSource::kSimulation) return {};
    return asked(
        "Hold the calibration board so that it fills most of both pictures, evenly lit, as for calibrating; press "
        "Enter, and keep it still until the last line.");
  }

  Result<BoardLook> look_at(const ExposureSetting& setting) {
    Result<BoardLook> look = opened(setting).and_then(look_at_board);
    if (look) show(*look);
    return look;
  }

  void show(const BoardLook& look) const {
    if (options_.json) {
      const ordered_json line = {{"exposure_us", look.setting.exposure.count()},
                                 {"gain", look.setting.gain},
                                 {"left", json_of(look, Side::kLeft)},
                                 {"right", json_of(look, Side::kRight)}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("{:>6} us, gain {}: {}; {}\n", look.setting.exposure.count(), look.setting.gain,
                 words(look, Side::kLeft), words(look, Side::kRight));
      std::fflush(stdout);  // someone waits with a board in hand
    }
  }

  [[nodiscard]] int conclude(const BoardLook& look) const {
    const std::vector<ConfigEdit> edits = edits_of("cameras.calibrating", look.setting);
    if (const Result<void> written = written_where_asked(options_, edits); !written) return report(written.error());
    if (options_.json) {
      const ordered_json line = {{"setting", "calibrating"},
                                 {"exposure_us", look.setting.exposure.count()},
                                 {"gain", look.setting.gain},
                                 {"left", json_of(look, Side::kLeft)},
                                 {"right", json_of(look, Side::kRight)},
                                 {"written", options_.write}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("calibrating: {} us, gain {}; checked in fresh pictures: {}; {} of clip\n{}",
                 look.setting.exposure.count(), look.setting.gain, words(look, Side::kLeft), words(look, Side::kRight),
                 written_text(options_, edits));
    }
    return number(ExitCode::kWell);
  }

  const ExposeOptions& options_;
  const Config& config_;
  SystemClock clock_;
};

}  // namespace

int expose_for_calibrating(const ExposeOptions& options, const Config& config) {
  return Exposing(options, config).run();
}

}  // namespace tripoint
