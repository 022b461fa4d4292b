// The lowest gain that makes a picture light enough.
#pragma once

#include <functional>
#include <optional>

#include "ports/camera.h"
#include "values/result.h"

namespace tripoint {

using LightEnough = std::function<Result<bool>(int gain)>;

/// Goes up from `from` in steps that double, so that nothing far too light is tried, and then halves the last step.
///
/// @param from  known to be too dark
/// @return nothing when not even the highest gain is enough; errors of `light_enough`
Result<std::optional<int>> lowest_gain(const GainRange& offered, int from, const LightEnough& light_enough);

}  // namespace tripoint
