#include "app/board_search.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/exposure_steps.h"
#include "app/gain_search.h"

namespace tripoint {
namespace {

using std::chrono::microseconds;

constexpr double kNear = 1.06;          ///< a factor: nearer to the middle of the range need not be
constexpr double kOutOfClipping = 0.5;  ///< a factor of light: how much is too much, a clipped white does not tell
constexpr double kEnoughForGain = 1.1;  ///< over the lower end of the range: gains have steps, and pictures noise
const double kMiddle = std::sqrt(kBoardWhiteFrom * kBoardWhiteTo);

/// The board's white in both cameras; of the darker and of the lighter one.
struct Whites {
  double darker;
  double lighter;
};

std::optional<Whites> in_both(const BoardLook& look) {
  if (!look.board.left.levels || !look.board.right.levels) return std::nullopt;
  const auto [darker, lighter] = std::minmax(look.board.left.levels->white, look.board.right.levels->white);
  return Whites{darker, lighter};
}

double factor_to_middle(const Whites& whites) {
  if (whites.lighter >= kClippedWhite) return kOutOfClipping;
  return std::clamp(kMiddle / std::sqrt(whites.darker * whites.lighter), 1.0 / kLargestExposureStep,
                    kLargestExposureStep);
}

/// Of the camera that shows less of a board.
double share(const BoardLook& look) { return std::min(look.board.left.share, look.board.right.share); }

/// Goes away from the start to both sides until both cameras see the board; else the look that shows most of it.
Result<BoardLook> first_sight(const LookAtBoard& look_at, const ExposureOffer& offered, const ExposureSetting& start) {
  BoardLook most{.setting = start, .board = {}};
  for (const microseconds exposure : exposures_around(offered, start.exposure)) {
    Result<BoardLook> look = look_at({exposure, start.gain});
    if (!look || in_both(*look)) return look;
    if (share(*look) >= share(most)) most = *look;
  }
  return most;
}

/// Changes the exposure until white is near the middle of the range.
Result<BoardLook> nearer_to_middle(const LookAtBoard& look_at, const ExposureOffer& offered, BoardLook look) {
  ExposureBracket bracket;
  for (int step = 0; step < kMostExposureSteps && in_both(look); ++step) {
    const double factor = factor_to_middle(*in_both(look));
    if (factor < kNear && factor > 1.0 / kNear) break;
    const double wanted_us = bracket.next_us(microseconds_of(look.setting.exposure), factor);
    const microseconds next = exposure_within(offered, wanted_us);
    if (next == look.setting.exposure) break;
    Result<BoardLook> better = look_at({next, look.setting.gain});
    if (!better || !in_both(*better)) return better.map([&](const BoardLook&) { return look; });
    look = *better;
  }
  return look;
}

/// What is seen with the lowest gain that is enough for the longest exposure, or with the highest.
Result<BoardLook> with_more_gain(const LookAtBoard& look_at, const ExposureOffer& offered, const BoardLook& without) {
  BoardLook not_enough = without;
  BoardLook enough;
  const LightEnough light_enough = [&](int gain) {
    return look_at({offered.longest, gain}).map([&](const BoardLook& look) {
      const std::optional<Whites> whites = in_both(look);
      const bool is_enough = whites && whites->darker >= kEnoughForGain * kBoardWhiteFrom;
      if (whites) (is_enough ? enough : not_enough) = look;
      return is_enough;
    });
  };
  const Result<std::optional<int>> gain = lowest_gain(offered.gains, without.setting.gain, light_enough);
  if (!gain) return tl::make_unexpected(gain.error());
  return *gain ? nearer_to_middle(look_at, offered, enough) : Result<BoardLook>(not_enough);
}

std::string setting_text(const ExposureSetting& setting) {
  return fmt::format("{} us with gain {}", setting.exposure.count(), setting.gain);
}

std::string whites_text(const BoardLook& look) {
  std::string text;
  for (const Side side : kBothSides) {
    text += fmt::format("{}white has {:.0f} % of clip in camera {}", text.empty() ? "" : ", ",
                        100.0 * look.board[side].levels->white, name(side));
  }
  return text;
}

Error not_seen(const BoardLook& look) {
  std::string where;
  for (const Side side : kBothSides) {
    if (look.board[side].levels) continue;
    where += fmt::format("{}on {:.0f} % of camera {}'s picture", where.empty() ? "" : " and ",
                         100.0 * look.board[side].share, name(side));
  }
  return {
      ErrorCode::kTimeout,
      fmt::format("no board of black and white is seen by both cameras: with {} there is something like it {}; hold "
                  "it so that it fills at least a quarter of both pictures, and put light on it",
                  setting_text(look.setting), where)};
}

Result<void> check_whites(const BoardLook& look, const Whites& whites, const ExposureOffer& offered) {
  const bool too_dark = whites.darker < kBoardWhiteFrom;
  const bool too_light = whites.lighter > kBoardWhiteTo;
  if (!too_dark && !too_light) return {};
  std::string why = "the cameras see it too differently: turn it so that both see it equally lit";
  if (too_dark && look.setting.exposure >= offered.longest) {
    why = "too dark even at the longest exposure: put more light on the board, or open the iris";
  } else if (too_light && look.setting.exposure <= offered.shortest) {
    why = "too light even at the shortest exposure: take light away, or close the iris";
  }
  return failure(
      ErrorCode::kOutOfRange,
      fmt::format("the board's white should have {:.0f} to {:.0f} % of clip; with {} {}; {}", 100.0 * kBoardWhiteFrom,
                  100.0 * kBoardWhiteTo, setting_text(look.setting), whites_text(look), why));
}

}  // namespace

Result<void> check_board(const BoardLook& look, const ExposureOffer& offered) {
  const std::optional<Whites> whites = in_both(look);
  if (!whites) return tl::make_unexpected(not_seen(look));
  if (Result<void> checked = check_whites(look, *whites, offered); !checked) return checked;
  for (const Side side : kBothSides) {
    const BoardLevels& levels = *look.board[side].levels;
    if (levels.lightest >= kClippedWhite) {
      return failure(ErrorCode::kOutOfRange,
                     fmt::format("glare: with {} white has {:.0f} % of clip in camera {}, but a part of the board "
                                 "clips; turn the board away from the lamp, or use a matt one",
                                 setting_text(look.setting), 100.0 * levels.white, name(side)));
    }
    if (levels.white < kLeastBoardContrast * levels.black) {
      return failure(ErrorCode::kOutOfRange,
                     fmt::format("pale: in camera {} white has {:.0f} % of clip and black {:.0f} %, where white should "
                                 "have twice as much at least; keep light off the lens and the board's face, or print "
                                 "it darker",
                                 name(side), 100.0 * levels.white, 100.0 * levels.black));
    }
  }
  return {};
}

Result<BoardLook> search_for_board(const LookAtBoard& look_at, const ExposureOffer& offered,
                                   const ExposureSetting& start) {
  const ExposureSetting first{exposure_within(offered, microseconds_of(start.exposure)), start.gain};
  Result<BoardLook> look = first_sight(look_at, offered, first).and_then([&](const BoardLook& seen) {
    return nearer_to_middle(look_at, offered, seen);
  });
  const auto needs_gain = [&] {
    return !in_both(*look) || (look->setting.exposure >= offered.longest && in_both(*look)->darker < kBoardWhiteFrom);
  };
  if (look && needs_gain()) look = with_more_gain(look_at, offered, *look);
  if (!look) return look;
  return check_board(*look, offered).map([&] { return *look; });
}

}  // namespace tripoint
