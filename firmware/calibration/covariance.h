// Whether a matrix can be the covariance of a calibration.
#pragma once

#include <string>

#include "geometry/rig.h"

namespace tripoint {

/// Symmetric to 1e-6 of the standard deviations involved, no variance negative, positive semidefinite to 1e-6 after
/// scaling to correlations: files written with few digits pass, wrong ones do not.
///
/// @return what is wrong and what is permitted; "" when nothing is
std::string fault_of_covariance(const RigCovariance& covariance);

}  // namespace tripoint
