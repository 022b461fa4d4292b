// Accuracy and cost of the spot fit alone.
#pragma once

#include <vector>

#include "bench/figure.h"

namespace tripoint::bench {

/// `centroid_rms_vs_bound` and `centroid_us`.
std::vector<Figure> centroid_figures();

}  // namespace tripoint::bench
