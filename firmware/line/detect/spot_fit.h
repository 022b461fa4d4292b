// The centre of a spot: a Gaussian, integrated over each pixel, on a constant ground.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "values/linear.h"

namespace tripoint {

/// Values and weights of the pixels to fit: weight 0 hides a clipped or foreign pixel, 1 is a whole one.
class FitWindow {
 public:
  static constexpr int kMaxSide = 84;

  /// Every value and weight 0.
  void resize(int columns, int rows);
  [[nodiscard]] float* values(int row) { return values_.data() + index(0, row); }
  [[nodiscard]] float* weights(int row) { return weights_.data() + index(0, row); }
  /// A row's values up to the end of its last vector of 4; those beyond its columns have to stay 0.
  [[nodiscard]] std::span<float> whole_vectors(int row) { return {values(row), stride_}; }
  void set(int column, int row, float value, float weight) {
    values_[index(column, row)] = value;
    weights_[index(column, row)] = weight;
  }

  /// Takes the weight from a pixel and its four neighbours.
  void hide_around(int column, int row);

  /// Scales the weights around a place: 0 up to `from_px` of distance, rising smoothly to 1 at `to_px`.
  void fade_around(double column, double row, double from_px, double to_px);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] float value(int column, int row) const { return values_[index(column, row)]; }
  [[nodiscard]] float weight(int column, int row) const { return weights_[index(column, row)]; }
  /// The start of a row; whole vectors of 4 may be read, their rest has weight 0.
  [[nodiscard]] const float* values(int row) const { return values_.data() + index(0, row); }
  [[nodiscard]] const float* weights(int row) const { return weights_.data() + index(0, row); }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(column);
  }
  int columns_ = 0;
  int rows_ = 0;
  std::size_t stride_ = 0;  ///< whole vectors of 4
  std::array<float, std::size_t{kMaxSide} * kMaxSide> values_{};
  std::array<float, std::size_t{kMaxSide} * kMaxSide> weights_{};
};

/// Coordinates are window columns and rows, pixel centres at integers.
struct SpotModel {
  double column = 0.0;
  double row = 0.0;
  double sigma_px = 1.0;
  double amplitude = 0.0;  ///< of the Gaussian before the pixels integrate it
  double background = 0.0;
};

struct SpotFit {
  SpotModel model;
  Matrix2 covariance_px2 = Matrix2::Identity();  ///< inverse Fisher information, background and shape unknown too
  double noise = 0.0;                            ///< RMS of the residuals, per pixel
  double visible_amplitude = 0.0;                ///< of the brightest pixel with weight
  int pixels = 0;
};

/// Where to begin: moments of what rises above 20 % of the contrast over `background`, hidden pixels included.
SpotModel threshold_subtracted_start(const FitWindow& window, double background);

inline constexpr double kSettled_px = 0.05;  ///< of centre and sigma; the step itself leaves a small part of it

/// Gauss-Newton with light damping, at most 7 steps.
///
/// @param settled_px  no step follows one that moved centre and sigma by less
/// @return nothing when the weights sum up to fewer than 12 pixels or the normal equations are singular
/// Source: Winick 1986, "Cramer-Rao lower bounds on the performance of CCD optical position estimators".
std::optional<SpotFit> fit_spot(const FitWindow& window, const SpotModel& start, double settled_px = kSettled_px);

}  // namespace tripoint
