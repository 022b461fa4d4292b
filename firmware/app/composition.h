// Puts the unit together and runs it: the only place that makes threads.
#pragma once

#include <functional>

#include "config/config.h"
#include "values/result.h"

namespace tripoint {

/// Measures and serves while `until_stop` runs; it returns when the unit shall stop. A missing camera is waited for.
///
/// @return an error only before anything runs: a file that is missing or wrong, or a port in use
Result<void> run_unit(const Config& config, const std::function<void()>& until_stop);

}  // namespace tripoint
