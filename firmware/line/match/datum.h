// Which spots are the fixed datum: it stands where it stood, so that its place tells it from the target.
#pragma once

#include <optional>

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/model.h"

namespace tripoint {

/// What both cameras saw, parted into the datum and everything else.
struct Sifted {
  Aligned others;             ///< without the spots that are, or could be, the datum
  std::optional<Pair> datum;  ///< id 0; nothing when its spots are not alike, as where another light touches one
  bool ambiguous = false;     ///< two pairs or more could be it: none is, and none is among the others
};

/// A pair is the datum when both spots lie where its ball of `radius_mm` appears, and their rays come nearest to each
/// other within that ball. How far the spots lie from a common epipolar plane is not asked: a camera that was knocked
/// shows the datum still. The model has a datum and a calibration.
Sifted without_datum(const Aligned& seen, const LineModel& model);

}  // namespace tripoint
