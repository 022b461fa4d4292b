// How light the white and the black of a calibration board are in a picture.
#pragma once

#include <optional>

#include "ports/frame.h"

namespace tripoint {

/// In units of clip: level_from_luma.
struct BoardLevels {
  double white = 0.0;     ///< the median over all parts of the board
  double black = 0.0;     ///< likewise
  double lightest = 0.0;  ///< white in all but a twentieth of the parts: where the board shines
};

/// From here on white has clipped, and how much is not known.
inline constexpr double kClippedWhite = 0.95;

struct BoardSight {
  std::optional<BoardLevels> levels;  ///< nothing: no board is seen
  double share = 0.0;                 ///< of the picture that is the midst of a board
};

/// Any board of black and white squares or tags, at any place: the picture is cut into 20 columns of square parts. A
/// part is of a board when it has two levels, little between, and neighbours likewise: other things have such parts
/// along their edges only. Fewer parts than 6 % of the picture are no board.
///
/// Source of the two levels: N. Otsu 1979, "A Threshold Selection Method from Gray-Level Histograms", the threshold by
/// equation 14, and how well it parts both by equation 12 (eta).
BoardSight board_sight(const Picture& picture);

}  // namespace tripoint
