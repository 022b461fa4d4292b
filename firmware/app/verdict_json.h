// One verdict of the line as one line of JSON, as `tripointd replay` prints it.
#pragma once

#include <string>

#include "line/measurement.h"
#include "line/model.h"

namespace tripoint {

/// The keys and units of `tripointd replay`: null = unknown; covariances are 3x3 without an orientation, else 6x6.
std::string verdict_json(const Measurement& measurement, OutputFrame frame);

}  // namespace tripoint
