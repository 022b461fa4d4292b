// Seeded noise for Monte Carlo tests; the seed is printed and can be given as TRIPOINT_SEED.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

namespace tripoint::testing {

class Noise {
 public:
  explicit Noise(std::uint64_t seed) {
    const char* given = std::getenv("TRIPOINT_SEED");
    const std::uint64_t used = given != nullptr ? std::strtoull(given, nullptr, 10) : seed;
    std::cout << "seed " << used << '\n';
    engine_.seed(used);
  }

  double normal() { return normal_(engine_); }

  template <int N>
  Eigen::Matrix<double, N, 1> vector(const Eigen::Matrix<double, N, N>& covariance) {
    const Eigen::Matrix<double, N, N> root = covariance.llt().matrixL();
    Eigen::Matrix<double, N, 1> unit;
    for (int i = 0; i < N; ++i) unit[i] = normal();
    return root * unit;
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_{0.0, 1.0};
};

/// Mean and covariance of what has been added.
template <int N = 3>
class Spread {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  void add(const Vector& value) {
    ++count_;
    const Vector from_old_mean = value - mean_;
    mean_ += from_old_mean / count_;
    sum_ += from_old_mean * (value - mean_).transpose();
  }
  [[nodiscard]] Matrix covariance() const { return sum_ / (count_ - 1.0); }

 private:
  double count_ = 0.0;
  Vector mean_ = Vector::Zero();
  Matrix sum_ = Matrix::Zero();
};

/// Largest entry of root^-1 measured root^-T - 1: how far two covariances differ, whatever their directions.
template <int N>
double relative_difference(const Eigen::Matrix<double, N, N>& measured, const Eigen::Matrix<double, N, N>& stated) {
  using Matrix = Eigen::Matrix<double, N, N>;
  const Matrix root = stated.llt().matrixL();
  const Matrix inverse = root.inverse();
  return (inverse * measured * inverse.transpose() - Matrix::Identity()).cwiseAbs().maxCoeff();
}

}  // namespace tripoint::testing
