// Candidates with their numbers, and which of them people want to see first.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "line/detect/candidate.h"
#include "line/detect/led_detector.h"
#include "values/linear.h"

namespace tripoint {

struct Finding {
  int number = 0;  ///< place in the detector's log, from 1
  Candidate candidate;
  std::optional<Matrix2> covariance_px2;  ///< of a kept one

  [[nodiscard]] bool kept() const { return candidate.cause == DropCause::kKept; }
};

/// @param log,detection  of one picture: the kept candidates are the points, in the same order
/// @return the kept ones in the order of the log, then the dropped ones: of each cause the one that came closest to
///         being kept, then of each the next
std::vector<Finding> findings_of(const CandidateLog& log, const Detection& detection);

/// "3 not red, 1 dim": causes with their number, the most frequent first; empty when nothing was dropped.
std::string tally_of_dropped(std::span<const Finding> findings);

}  // namespace tripoint
