// Where to begin looking: the reddest pixel of a cell, or beside a spot that was already accepted.
#pragma once

#include <optional>

#include "line/detect/candidate.h"
#include "line/detect/coarse.h"
#include "line/detect/select.h"
#include "ports/frame.h"

namespace tripoint {

/// The pixel of largest V in a selected cell, brightest of equal ones.
PixelPlace reddest_of_cell(const Picture& picture, const CoarseMap& map, const Cell& cell);

/// The reddest pixel beside an accepted spot: a second LED within 26 px hides behind the first one's cell.
///
/// @return nothing when no pixel outside the spot is nearly as red as its core
std::optional<PixelPlace> reddest_beside(const Picture& picture, const CoarseMap& map, const Candidate& spot,
                                         int min_red);

}  // namespace tripoint
