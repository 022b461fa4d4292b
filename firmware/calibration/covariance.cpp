#include "calibration/covariance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

namespace tripoint {
namespace {

constexpr double kTolerance = 1e-6;  // correlations written with six digits

/// Entries over the product of both standard deviations; entries of a parameter without variance stay as they are.
RigCovariance correlations(const RigCovariance& covariance) {
  const RigParameters scale =
      covariance.diagonal().unaryExpr([](double variance) { return variance > 0.0 ? 1.0 / std::sqrt(variance) : 1.0; });
  return scale.asDiagonal() * covariance * scale.asDiagonal();
}

}  // namespace

std::string fault_of_covariance(const RigCovariance& covariance) {
  for (int i = 0; i < covariance.rows(); ++i) {
    if (!(covariance(i, i) >= 0.0)) {
      return fmt::format("row {}: variance {}; permitted is 0 or more", i + 1, covariance(i, i));
    }
  }
  const RigCovariance scaled = correlations(covariance);
  int row = 0;
  int column = 0;
  const RigCovariance difference = (scaled - scaled.transpose()).cwiseAbs();
  if (difference.maxCoeff(&row, &column) > kTolerance) {
    return fmt::format("row {}, column {}: {} one way, {} the other; permitted is a symmetric matrix",
                       std::min(row, column) + 1, std::max(row, column) + 1, covariance(row, column),
                       covariance(column, row));
  }
  const double least = Eigen::SelfAdjointEigenSolver<RigCovariance>{scaled, Eigen::EigenvaluesOnly}.eigenvalues()[0];
  if (!(least >= -kTolerance)) {
    return fmt::format("smallest eigenvalue of the correlations {:.3g}; permitted is a positive semidefinite matrix",
                       least);
  }
  return {};
}

}  // namespace tripoint
