#include "line/detect/spot_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace tripoint {
namespace {

constexpr double kNoise = 2.0;
constexpr double kBackground = 20.0;

double integrated(int pixel, double center, double sigma) {
  const double q = 1.0 / (sigma * std::numbers::sqrt2);
  return sigma * std::sqrt(std::numbers::pi / 2.0) *
         (std::erf((pixel + 0.5 - center) * q) - std::erf((pixel - 0.5 - center) * q));
}

/// `clip`: values above it are cut and hidden.
std::unique_ptr<FitWindow> painted(const SpotModel& spot, int side, double clip, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, kNoise);
  auto window = std::make_unique<FitWindow>();
  window->resize(side, side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double value = spot.background + spot.amplitude * integrated(column, spot.column, spot.sigma_px) *
                                                 integrated(row, spot.row, spot.sigma_px);
      const double seen = std::round(std::min(value + noise(random), clip));
      window->set(column, row, static_cast<float>(seen), seen >= clip ? 0.0F : 1.0F);
    }
  }
  return window;
}

struct Statistics {
  double chi2_per_axis = 0.0;
  double rms_px = 0.0;
  double bias_u_px = 0.0;
  double bias_v_px = 0.0;
  int failures = 0;
};

Statistics statistics_of(double amplitude, double sigma_px, double clip, int draws) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  const int side = 2 * static_cast<int>(std::ceil(3.0 * sigma_px) + 2) + 1;
  Statistics result;
  for (int draw = 0; draw < draws; ++draw) {
    const double middle = (side - 1) / 2.0;
    const SpotModel truth{middle + offset(random), middle + offset(random), sigma_px, amplitude, kBackground};
    const auto window = painted(truth, side, clip, random);
    const auto fit = fit_spot(*window, threshold_subtracted_start(*window, kBackground));
    if (!fit) {
      ++result.failures;
      continue;
    }
    const Vec2 error(fit->model.column - truth.column, fit->model.row - truth.row);
    result.chi2_per_axis += 0.5 * error.dot(fit->covariance_px2.inverse() * error) / draws;
    result.rms_px += 0.5 * error.squaredNorm() / draws;
    result.bias_u_px += error.x() / draws;
    result.bias_v_px += error.y() / draws;
  }
  result.rms_px = std::sqrt(result.rms_px);
  return result;
}

TEST(SpotFitTest, CovarianceHoldsOverDrawnNoise) {
  // The mean of chi2 over 2 x 2000 draws has a standard deviation of sqrt(2 / 4000) = 0.022; 4 of them, and 3 % for
  // the variance that is estimated from about 200 pixels.
  for (const double sigma_px : {1.0, 1.8, 3.0}) {
    const Statistics result = statistics_of(80.0, sigma_px, 255.0, 2000);
    EXPECT_EQ(result.failures, 0);
    EXPECT_NEAR(result.chi2_per_axis, 1.0, 0.12) << "sigma " << sigma_px;
  }
}

TEST(SpotFitTest, CentreIsUnbiased) {
  const Statistics result = statistics_of(80.0, 1.8, 255.0, 2000);
  const double of_mean_px = result.rms_px / std::sqrt(2000.0);
  EXPECT_NEAR(result.bias_u_px, 0.0, 4.0 * of_mean_px);
  EXPECT_NEAR(result.bias_v_px, 0.0, 4.0 * of_mean_px);
}

TEST(SpotFitTest, HiddenClippedCoreLeavesTheCovarianceTrue) {
  // Three times over the clip: the flank alone is left. Pixels are hidden by their noisy value, which shifts the
  // sample a little: 20 %.
  const Statistics result = statistics_of(240.0, 2.0, 100.0, 2000);
  EXPECT_EQ(result.failures, 0);
  EXPECT_NEAR(result.chi2_per_axis, 1.0, 0.2);
  EXPECT_LT(result.rms_px, 0.05);
}

TEST(SpotFitTest, FadedCoreDoesNotUnderstateTheCovariance) {
  // The fit takes a faded pixel for a noisier one than it is, so that it states too much rather than too little: chi2
  // may exceed 1 by 4 standard deviations (0.09) and 3 % only. At half of that, twice the variance would be stated.
  std::mt19937 random(22);
  constexpr int kDraws = 2000;
  double chi2_per_axis = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const SpotModel truth{8.3, 7.8, 2.0, 80.0, kBackground};
    const auto window = painted(truth, 17, 255.0, random);
    window->fade_around(truth.column, truth.row, 1.5, 4.5);
    const auto fit = fit_spot(*window, truth);
    ASSERT_TRUE(fit);
    const Vec2 error(fit->model.column - truth.column, fit->model.row - truth.row);
    chi2_per_axis += 0.5 * error.dot(fit->covariance_px2.inverse() * error) / kDraws;
  }
  EXPECT_LT(chi2_per_axis, 1.12);
  EXPECT_GT(chi2_per_axis, 0.5);
}

/// Of the centre, from the derivatives of the painted spot by its five parameters, for noise of one step a pixel.
Matrix2 covariance_by_differences(const FitWindow& window, const SpotModel& spot) {
  constexpr double kStep = 1e-4;
  Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
  for (int row = 0; row < window.rows(); ++row) {
    for (int column = 0; column < window.columns(); ++column) {
      if (window.weight(column, row) <= 0.0F) continue;
      const auto value = [&](int parameter, double step) {
        std::array<double, 5> p{spot.column, spot.row, spot.sigma_px, spot.amplitude, spot.background};
        p[static_cast<std::size_t>(parameter)] += step;
        return p[4] + p[3] * integrated(column, p[0], p[2]) * integrated(row, p[1], p[2]);
      };
      Eigen::Matrix<double, 5, 1> derivatives;
      for (int i = 0; i < 5; ++i) derivatives(i) = (value(i, kStep) - value(i, -kStep)) / (2.0 * kStep);
      information += derivatives * derivatives.transpose();
    }
  }
  return information.inverse().topLeftCorner<2, 2>();
}

TEST(SpotFitTest, CovarianceOfAHalfHiddenSpotIsThatOfItsVisiblePixels) {
  // One flank alone hardly tells the centre from size and height. The covariance is that of the place before the last
  // step, up to 0.05 px off, where the flank's slope of one in two sigma differs by up to 2.5 %: 5 % of a variance.
  for (const int hidden_from : {9, 8, 7, 6}) {
    const SpotModel truth{8.2, 7.9, 2.0, 80.0, kBackground};
    std::mt19937 random(23);
    const auto window = painted(truth, 17, 255.0, random);
    for (int row = 0; row < 17; ++row) {
      for (int column = hidden_from; column < 17; ++column) window->set(column, row, 0.0F, 0.0F);
    }
    const auto fit = fit_spot(*window, truth);
    ASSERT_TRUE(fit);
    const Matrix2 expected_px2 = fit->noise * fit->noise * covariance_by_differences(*window, fit->model);
    EXPECT_NEAR(fit->covariance_px2(0, 0) / expected_px2(0, 0), 1.0, 0.05) << "hidden from column " << hidden_from;
    EXPECT_NEAR(fit->covariance_px2(1, 1) / expected_px2(1, 1), 1.0, 0.05) << "hidden from column " << hidden_from;
  }
}

/// A spot as only the red pixels of the mosaic see it (even columns of even rows), clipped and interpolated.
std::unique_ptr<FitWindow> mosaic(const SpotModel& spot, int side, double clip) {
  const auto red = [&](int column, int row) {
    return std::min(clip, spot.amplitude * integrated(column, spot.column, spot.sigma_px) *
                              integrated(row, spot.row, spot.sigma_px));
  };
  auto window = std::make_unique<FitWindow>();
  window->resize(side, side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const int u = column & 1;
      const int v = row & 1;
      const double value = 0.25 * (red(column - u, row - v) + red(column + u, row - v) + red(column - u, row + v) +
                                   red(column + u, row + v));
      window->set(column, row, static_cast<float>(value), 1.0F);
    }
  }
  return window;
}

/// RMS error of the centre over 8 x 8 places in the mosaic's cell, without noise, clipped at half the amplitude.
double mosaic_error_px(double sigma_px, bool faded) {
  constexpr double kClip = 100.0;
  double squares_px2 = 0.0;
  for (int place = 0; place < 64; ++place) {
    const SpotModel truth{9.0 + place % 8 / 4.0, 9.0 + place / 8 / 4.0, sigma_px, 2.0 * kClip, 0.0};
    const auto window = mosaic(truth, 21, kClip);
    int clipped = 0;
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) {
        if (window->value(column, row) < 0.8F * static_cast<float>(kClip)) continue;
        ++clipped;
        if (!faded) window->hide_around(column, row);
      }
    }
    const double clipped_px = std::sqrt(clipped / std::numbers::pi);
    if (faded) window->fade_around(truth.column, truth.row, clipped_px, clipped_px + 3.0);
    const auto fit = fit_spot(*window, truth);
    if (!fit) return 1e9;
    squares_px2 +=
        0.5 * (std::pow(fit->model.column - truth.column, 2) + std::pow(fit->model.row - truth.row, 2)) / 64.0;
  }
  return std::sqrt(squares_px2);
}

TEST(SpotFitTest, FadedCoreIsDisplacedLessByTheMosaicThanAHiddenOne) {
  for (const double sigma_px : {1.5, 1.9, 2.3}) {
    EXPECT_LT(mosaic_error_px(sigma_px, true), 0.9 * mosaic_error_px(sigma_px, false)) << "sigma " << sigma_px;
  }
}

TEST(SpotFitTest, FewerThanTwelveVisiblePixelsGiveNothing) {
  std::mt19937 random(3);
  const SpotModel spot{2.0, 2.0, 1.0, 100.0, kBackground};
  const auto window = painted(spot, 5, 255.0, random);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      if (row * 5 + column >= 11) window->set(column, row, 0.0F, 0.0F);
    }
  }
  EXPECT_FALSE(fit_spot(*window, spot));
  window->set(1, 2, 60.0F, 1.0F);
  window->set(2, 2, 100.0F, 1.0F);
  EXPECT_TRUE(fit_spot(*window, spot));
}

TEST(SpotFitTest, FlatWindowGivesNothingOrASpotWithoutAmplitude) {
  FitWindow window;
  window.resize(11, 11);
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 11; ++column) window.set(column, row, 20.0F, 1.0F);
  }
  const auto fit = fit_spot(window, threshold_subtracted_start(window, 20.0));
  EXPECT_LT(fit ? fit->visible_amplitude : 0.0, 1.0);
}

}  // namespace
}  // namespace tripoint
