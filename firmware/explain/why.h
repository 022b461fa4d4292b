// In words and numbers why a candidate was kept or dropped.
#pragma once

#include <string>

#include "line/detect/candidate.h"
#include "line/detect/detector_settings.h"

namespace tripoint {

/// The name of the cause as people write it: "not red".
std::string cause_in_words(DropCause cause);

/// What decided: the measured value against its limit ("redness 0.31 < 0.70"), or in words where a gate measures
/// nothing; of a kept one what it measured.
///
/// @param width_px  of the picture: the largest spot depends on it
std::string why(const Candidate& candidate, const DetectorSettings& settings, int width_px);

}  // namespace tripoint
