#include "bench/detect_bench_centroid.h"

#include <Eigen/LU>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

#include "bench/interleaved.h"
#include "line/detect/spot_fit.h"

namespace tripoint::bench {
namespace {

constexpr double kNoise = 2.0;        ///< luma steps per pixel, before rounding
constexpr double kBackground = 20.0;  ///< luma

struct Spot {
  double column, row, sigma_px, amplitude;
};

double integrated(int pixel, double center, double sigma_px) {
  const double q = 1.0 / (sigma_px * std::numbers::sqrt2);
  return sigma_px * std::sqrt(std::numbers::pi / 2.0) *
         (std::erf((pixel + 0.5 - center) * q) - std::erf((pixel - 0.5 - center) * q));
}

int side_px(double sigma_px) { return 2 * static_cast<int>(std::ceil(3.0 * sigma_px) + 2) + 1; }

FitWindow painted(const Spot& spot, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, kNoise);
  const int side = side_px(spot.sigma_px);
  FitWindow window;
  window.resize(side, side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double value = kBackground + spot.amplitude * integrated(column, spot.column, spot.sigma_px) *
                                             integrated(row, spot.row, spot.sigma_px);
      window.set(column, row, static_cast<float>(std::round(std::clamp(value + noise(random), 0.0, 255.0))), 1.0F);
    }
  }
  return window;
}

double mean_of_border(const FitWindow& window) {
  const int last = window.columns() - 1;
  double sum = 0.0;
  for (int i = 0; i < last; ++i) {
    sum += static_cast<double>(window.value(i, 0) + window.value(last, i) + window.value(i + 1, last) +
                               window.value(0, i + 1));
  }
  return sum / (4.0 * last);
}

/// Variance per axis that no unbiased estimator can beat: centre, amplitude, background and sigma unknown,
/// derivatives by central differences of the exact model. Rounding adds 1/12 to the noise.
double bound_px2(const Spot& spot) {
  const auto value = [](const std::array<double, 5>& p, int column, int row) {
    return p[3] + p[2] * integrated(column, p[0], p[4]) * integrated(row, p[1], p[4]);
  };
  const std::array<double, 5> truth{spot.column, spot.row, spot.amplitude, kBackground, spot.sigma_px};
  Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
  for (int row = 0; row < side_px(spot.sigma_px); ++row) {
    for (int column = 0; column < side_px(spot.sigma_px); ++column) {
      Eigen::Matrix<double, 5, 1> slope;
      for (int k = 0; k < 5; ++k) {
        constexpr double kStep = 1e-4;
        auto above = truth;
        auto below = truth;
        above[static_cast<std::size_t>(k)] += kStep;
        below[static_cast<std::size_t>(k)] -= kStep;
        slope(k) = (value(above, column, row) - value(below, column, row)) / (2.0 * kStep);
      }
      information += slope * slope.transpose();
    }
  }
  return (kNoise * kNoise + 1.0 / 12.0) * information.inverse().topLeftCorner<2, 2>().trace() / 2.0;
}

Figure rms_against_bound() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  double squares = 0.0;  // of errors, each over its own bound: every kind of spot counts the same
  double worst = 0.0;
  int kinds = 0;
  for (const double amplitude : {60.0, 120.0, 200.0}) {
    for (const double sigma_px : {1.0, 1.5, 2.0, 3.0}) {
      constexpr int kDraws = 2000;
      double of_kind = 0.0;
      for (int draw = 0; draw < kDraws; ++draw) {
        const double middle = (side_px(sigma_px) - 1) / 2.0;
        const Spot spot{middle + offset(random), middle + offset(random), sigma_px, amplitude};
        const FitWindow window = painted(spot, random);
        const auto fit = fit_spot(window, threshold_subtracted_start(window, mean_of_border(window)));
        if (!fit) return {.name = "centroid_rms_vs_bound", .value = 1e9, .unit = "ratio"};
        const double du = fit->model.column - spot.column;
        const double dv = fit->model.row - spot.row;
        of_kind += 0.5 * (du * du + dv * dv) / bound_px2(spot) / kDraws;
      }
      squares += of_kind;
      worst = std::max(worst, of_kind);
      ++kinds;
    }
  }
  std::fprintf(stderr, "centroid: worst kind of spot %.3f x the bound\n", std::sqrt(worst));
  const double ratio = std::sqrt(squares / kinds);
  return at_most({.name = "centroid_rms_vs_bound", .value = ratio, .unit = "ratio", .baseline = 1.0, .ratio = ratio},
                 1.05);
}

Figure time_of_a_spot() {
  constexpr std::size_t kSpots = 64;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  std::vector<FitWindow> windows;
  for (std::size_t i = 0; i < kSpots; ++i) {
    const double middle = (side_px(1.5) - 1) / 2.0;
    windows.push_back(painted({middle + offset(random), middle + offset(random), 1.5, 120.0}, random));
  }
  double kept = 0.0;
  const auto all = [&](std::size_t) {
    for (const FitWindow& window : windows) {
      const auto fit = fit_spot(window, threshold_subtracted_start(window, mean_of_border(window)));
      kept += fit ? fit->model.column : 0.0;
    }
  };
  const double us = interleaved_medians_us({all}, 201).front() / kSpots;
  if (!std::isfinite(kept)) return {};
  return at_most({.name = "centroid_us", .value = us, .unit = "us"}, 3.0);
}

}  // namespace

std::vector<Figure> centroid_figures() { return {rms_against_bound(), time_of_a_spot()}; }

}  // namespace tripoint::bench
