// Which exposure and gain show a calibration board well: pure, the cameras are behind a function.
#pragma once

#include <functional>
#include <optional>

#include "app/board_levels.h"
#include "app/camera_pair.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// The board's white in units of clip: light enough for little noise, dark enough that no edge is moved by clipping.
inline constexpr double kBoardWhiteFrom = 0.55;
inline constexpr double kBoardWhiteTo = 0.80;
/// White over black, at least. Paper over toner is 10 to 30, in a camera with a display's gamma 3 to 5.
inline constexpr double kLeastBoardContrast = 2.0;

/// What one setting shows of a board.
struct BoardLook {
  ExposureSetting setting;
  PerSide<BoardSight> board;
};

using LookAtBoard = std::function<Result<BoardLook>(const ExposureSetting& setting)>;

/// Looks until the board's white is near the middle of the range in both cameras. Light is proportional to the
/// exposure; a camera with a display's gamma only takes more steps. The gain is raised only where the longest exposure
/// is too short, and no more than needed.
///
/// @param start  where to begin; the gain is not lowered
/// @return a look that suits both; kTimeout, naming the camera, when none shows a board to both; otherwise as
///   check_board; errors of `look_at`
Result<BoardLook> search_for_board(const LookAtBoard& look_at, const ExposureOffer& offered,
                                   const ExposureSetting& start);

/// Whether both cameras show the board well.
///
/// @return kTimeout, naming the camera, when one sees no board; kOutOfRange, with the reason and what to do, when white
///   is outside the range, a part of it clips, or black is not distinct
Result<void> check_board(const BoardLook& look, const ExposureOffer& offered);

}  // namespace tripoint
