// Which cells of the coarse map may hold a spot: local maxima of V that stand alone.
#pragma once

#include <cstdint>

#include "line/detect/coarse.h"
#include "line/detect/settings.h"
#include "values/fixed_vector.h"

namespace tripoint {

struct Cell {
  std::int16_t u_px = 0;  ///< upper left corner
  std::int16_t v_px = 0;
  std::int16_t size_px = 0;
  std::int16_t contrast = 0;  ///< V above the mean of the ring
};

inline constexpr std::size_t kMaxCells = 512;

struct Selection {
  FixedVector<Cell, kMaxCells> cells;
  bool cut = false;  ///< more than `max_candidates`: those of least contrast were left out
};

/// A cell is selected when V >= min_red, no neighbour in 3x3 is larger (of equal ones the first in reading order
/// stands), and at most `max_ring_cells` of the 16 cells at distance 2 are within `ring_step` of it. Cells outside
/// the picture count as dark.
Selection select_cells(const CoarseMap& map, const LedDetectorSettings& settings);

}  // namespace tripoint
