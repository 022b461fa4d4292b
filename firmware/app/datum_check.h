// Whether a datum can be told from the target and be seen.
#pragma once

#include "config/config.h"
#include "line/model.h"
#include "values/result.h"

namespace tripoint {

/// @param model  of the same configuration; null: there is no calibration, and what needs one is not asked
/// @return kOutOfRange, naming the key, for a datum that lies less than its radius outside [volume], behind a camera or
///         outside a camera's picture
Result<void> check_datum(const Config& config, const LineModel* model);

}  // namespace tripoint
