#include "line/detect/spot_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "line/detect/spot_profile.h"
#include "line/detect/vectors.h"
#include "values/assert.h"

namespace tripoint {
namespace {

using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

constexpr int kMaxSteps = 7;
constexpr int kFewestPixels = 12;
constexpr double kDamping = 1e-3;
constexpr double kLargestAmplitude = 20'000.0;

/// Order of the parameters.
enum Parameter : std::uint8_t { kAmplitude, kBackground, kSigma, kColumn, kRow };

/// Normal equations for (A, background, sigma A, column A, row A): scaling by the amplitude A keeps them balanced, and
/// the centre comes last because the last block of a Cholesky factor is that of the block's own covariance.
struct Normal {
  Matrix5 matrix = Matrix5::Zero();  ///< its lower half
  Vector5 gradient = Vector5::Zero();
  double squares = 0.0;
  double pixels = 0.0;
  double visible = 0.0;  ///< largest model value with weight, over the amplitude
};

double sum(Floats4 v) {
  return static_cast<double>(v[0]) + static_cast<double>(v[1]) + static_cast<double>(v[2]) + static_cast<double>(v[3]);
}

/// 0 below 0, 1 above 1.
Floats4 clamped(Floats4 v) {
  const Floats4 one = Floats4{} + 1.0F;
  v = v > 0.0F ? v : Floats4{};
  return v < one ? v : one;
}

/// The sum of the lanes of each.
Floats4 sums(Floats4 a, Floats4 b, Floats4 c, Floats4 d) {
  const Floats4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Floats4 cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// Sums over one row of products of the profile e and its derivatives d (centre) and q (sigma), and of weighted
/// residuals r.
struct RowSums {
  Floats4 w{}, e{}, d{}, q{}, ee{}, ed{}, eq{}, dd{}, dq{}, qq{}, r{}, re{}, rd{}, rq{};
};

/// The model is a product of one factor across and one down: sums over all pixels are sums over the rows of what a row
/// says across, times the row's own e, d and q.
struct Accumulator {
  Floats4 once{};                     // of (w, r)
  Floats4 by_e{}, by_d{}, by_q{};     // of (e, d, q, re)
  Floats4 by_ee{}, by_ed{}, by_eq{};  // of (ee, ed, eq, dd)
  Floats4 by_ee_or_e{};               // of (dq, qq) and of (rd, rq)
  Floats4 by_dd_dq_qq{};              // of ee each
  Floats4 squares{};
  Floats4 visible{};

  void add(const RowSums& s, float e, float d, float q) {
    once += sums(s.w, s.r, s.w, s.r);
    const Floats4 first = sums(s.e, s.d, s.q, s.re);
    by_e += first * e;
    by_d += first * d;
    by_q += first * q;
    const Floats4 second = sums(s.ee, s.ed, s.eq, s.dd);
    by_ee += second * (e * e);
    by_ed += second * (e * d);
    by_eq += second * (e * q);
    by_dd_dq_qq += second[0] * Floats4{d * d, d * q, q * q, 0.0F};
    by_ee_or_e += sums(s.dq, s.qq, s.rd, s.rq) * Floats4{e * e, e * e, e, e};
  }

  [[nodiscard]] Normal total() const {
    Normal normal;
    const auto set = [&](int row, int column, float value) { normal.matrix(row, column) = static_cast<double>(value); };
    set(kAmplitude, kAmplitude, by_ee[0]);
    set(kBackground, kAmplitude, by_e[0]);
    set(kBackground, kBackground, once[0]);
    set(kSigma, kAmplitude, by_ee[2] + by_eq[0]);
    set(kSigma, kBackground, by_e[2] + by_q[0]);
    set(kSigma, kSigma, by_ee_or_e[1] + 2.0F * by_eq[2] + by_dd_dq_qq[2]);
    set(kColumn, kAmplitude, by_ee[1]);
    set(kColumn, kBackground, by_e[1]);
    set(kColumn, kSigma, by_ee_or_e[0] + by_eq[1]);
    set(kColumn, kColumn, by_ee[3]);
    set(kRow, kAmplitude, by_ed[0]);
    set(kRow, kBackground, by_d[0]);
    set(kRow, kSigma, by_ed[2] + by_dd_dq_qq[1]);
    set(kRow, kColumn, by_ed[1]);
    set(kRow, kRow, by_dd_dq_qq[0]);
    const Eigen::Matrix<float, 5, 1> gradient{by_e[3], once[1], by_ee_or_e[3] + by_q[3], by_ee_or_e[2], by_d[3]};
    normal.gradient = gradient.cast<double>();
    normal.squares = sum(squares);
    normal.pixels = static_cast<double>(once[0]);
    for (int i = 0; i < 4; ++i) normal.visible = std::max(normal.visible, static_cast<double>(visible[i]));
    return normal;
  }
};

Normal normal_equations(const FitWindow& window, const SpotModel& model) {
  const AxisProfile across(window.columns(), model.column, model.sigma_px);
  const AxisProfile down(window.rows(), model.row, model.sigma_px);
  const auto amplitude = static_cast<float>(model.amplitude);
  const auto background = static_cast<float>(model.background);
  Accumulator total;
  for (int row = 0; row < window.rows(); ++row) {
    const float e_row = down.value(row);
    const float scale = amplitude * e_row;
    RowSums s;
    for (int i = 0; i < window.columns(); i += 4) {
      const auto w = loaded<Floats4>(window.weights(row) + i);
      const auto e = loaded<Floats4>(across.values() + i);
      const auto d = loaded<Floats4>(across.by_center() + i);
      const auto q = loaded<Floats4>(across.by_sigma() + i);
      const Floats4 residual = loaded<Floats4>(window.values(row) + i) - background - scale * e;
      const Floats4 r = w * residual;
      const Floats4 we = w * e;
      const Floats4 wd = w * d;
      const Floats4 wq = w * q;
      s.w += w, s.e += we, s.d += wd, s.q += wq;
      s.ee += we * e, s.ed += we * d, s.eq += we * q, s.dd += wd * d, s.dq += wd * q, s.qq += wq * q;
      s.r += r, s.re += r * e, s.rd += r * d, s.rq += r * q;
      total.squares += r * residual;
      const Floats4 visible = we * e_row;
      total.visible = visible > total.visible ? visible : total.visible;
    }
    total.add(s, e_row, down.by_center()[row], down.by_sigma()[row]);
  }
  return total.total();
}

/// One damped step; each parameter may only move so far that a bad start cannot throw the spot away.
SpotModel stepped(const SpotModel& model, const Vector5& scaled_step) {
  const double a = model.amplitude;
  const double by_sigma = scaled_step(kSigma) / a;
  return {.column = model.column + std::clamp(scaled_step(kColumn) / a, -0.7, 0.7),
          .row = model.row + std::clamp(scaled_step(kRow) / a, -0.7, 0.7),
          .sigma_px = std::clamp(model.sigma_px + std::clamp(by_sigma, -0.35 * model.sigma_px, 0.5 * model.sigma_px),
                                 0.35, 24.0),
          .amplitude = std::clamp(a + std::clamp(scaled_step(kAmplitude), -0.6 * a, 1.5 * a), 1.0, kLargestAmplitude),
          .background = model.background + scaled_step(kBackground)};
}

/// What the normal equations at a place next to the minimum say of the minimum: they differ only in the residuals, and
/// there by what the step to it, times the gradient, takes off the sum of squares.
/// Its covariance is that of the bare equations: damping would hide a direction that the pixels hardly tell.
std::optional<SpotFit> fit_from(const Normal& normal, const SpotModel& model, const Vector5& scaled_step) {
  const Eigen::LLT<Matrix5> factor(normal.matrix);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Matrix2 of_center = factor.matrixLLT().bottomRightCorner<2, 2>().triangularView<Eigen::Lower>();
  const double squares = std::max(0.0, normal.squares - scaled_step.dot(normal.gradient));
  const double variance = squares / (normal.pixels - 5.0);
  const double per_px2 = variance / (model.amplitude * model.amplitude);
  SpotFit fit{.model = model,
              .covariance_px2 = (of_center * of_center.transpose()).inverse() * per_px2,
              .noise = std::sqrt(variance),
              .visible_amplitude = model.amplitude * normal.visible,
              .pixels = static_cast<int>(normal.pixels)};
  if (!fit.covariance_px2.allFinite()) return std::nullopt;
  return fit;
}

/// A trace of damping keeps the step finite where hardly a pixel shows.
Vector5 damped_step(const Normal& normal) {
  Matrix5 matrix = normal.matrix;
  matrix.diagonal() *= 1.0 + kDamping;
  matrix.diagonal().array() += 1e-9;
  return matrix.llt().solve(normal.gradient);
}

/// Moments of what rises above a threshold, row by row.
struct Moments {
  Floats4 n{}, x{}, xx{};
  float y = 0.0F, yy = 0.0F;
};

Moments moments_above(const FitWindow& window, float threshold) {
  Moments all;
  for (int row = 0; row < window.rows(); ++row) {
    Floats4 n{};
    Floats4 u{0.0F, 1.0F, 2.0F, 3.0F};
    for (int column = 0; column < window.columns(); column += 4, u += 4.0F) {
      const Floats4 rise = loaded<Floats4>(window.values(row) + column) - threshold;
      const Floats4 above = rise > 0.0F ? rise : Floats4{};
      n += above;
      all.x += above * u;
      all.xx += above * u * u;
    }
    all.n += n;
    const auto v = static_cast<float>(row);
    const auto in_row = static_cast<float>(sum(n));
    all.y += in_row * v;
    all.yy += in_row * v * v;
  }
  return all;
}

}  // namespace

void FitWindow::resize(int columns, int rows) {
  TRIPOINT_ASSERT(columns > 0 && columns <= kMaxSide && rows > 0 && rows <= kMaxSide);
  columns_ = columns;
  rows_ = rows;
  stride_ = (static_cast<std::size_t>(columns) + 3) & ~std::size_t{3};
  std::fill_n(values_.begin(), static_cast<std::size_t>(rows) * stride_, 0.0F);
  std::fill_n(weights_.begin(), static_cast<std::size_t>(rows) * stride_, 0.0F);
}

void FitWindow::hide_around(int column, int row) {
  weights_[index(column, row)] = 0.0F;
  if (column > 0) weights_[index(column - 1, row)] = 0.0F;
  if (column + 1 < columns_) weights_[index(column + 1, row)] = 0.0F;
  if (row > 0) weights_[index(column, row - 1)] = 0.0F;
  if (row + 1 < rows_) weights_[index(column, row + 1)] = 0.0F;
}

void FitWindow::fade_around(double column, double row, double from_px, double to_px) {
  TRIPOINT_ASSERT(from_px < to_px);
  const auto from2 = static_cast<float>(from_px * from_px);
  const auto per_px2 = static_cast<float>(1.0 / (to_px * to_px - from_px * from_px));
  const int first_row = std::max(0, static_cast<int>(std::ceil(row - to_px)));
  const int last_row = std::min(rows_ - 1, static_cast<int>(std::floor(row + to_px)));
  for (int y = first_row; y <= last_row; ++y) {
    const auto down2 = static_cast<float>((y - row) * (y - row));
    Floats4 across = Floats4{0.0F, 1.0F, 2.0F, 3.0F} - static_cast<float>(column);
    for (int x = 0; x < columns_; x += 4, across += 4.0F) {
      const Floats4 share = clamped((across * across + down2 - from2) * per_px2);
      store(weights(y) + x, loaded<Floats4>(weights(y) + x) * share * share * (3.0F - 2.0F * share));
    }
  }
}

SpotModel threshold_subtracted_start(const FitWindow& window, double background) {
  Floats4 largest{};
  for (int row = 0; row < window.rows(); ++row) {
    for (int column = 0; column < window.columns(); column += 4) {
      const auto values = loaded<Floats4>(window.values(row) + column);
      largest = values > largest ? values : largest;
    }
  }
  const auto peak = static_cast<double>(std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3])));
  const double contrast = std::max(1.0, peak - background);
  const Moments above = moments_above(window, static_cast<float>(background + 0.2 * contrast));
  const double n = sum(above.n);
  if (n <= 0.0) return {(window.columns() - 1) / 2.0, (window.rows() - 1) / 2.0, 1.0, contrast, background};
  const double column = sum(above.x) / n;
  const double row = static_cast<double>(above.y) / n;
  const double variance = 0.5 * ((sum(above.xx) + static_cast<double>(above.yy)) / n - column * column - row * row);
  // Cutting 20 % off a Gaussian leaves 0.6 of its variance.
  return {column, row, std::sqrt(std::max(variance / 0.6, 0.25)), 1.1 * contrast, background};
}

std::optional<SpotFit> fit_spot(const FitWindow& window, const SpotModel& start, double settled_px) {
  SpotModel model = start;
  for (int step = 1;; ++step) {
    const Normal normal = normal_equations(window, model);
    if (normal.pixels < kFewestPixels) return std::nullopt;
    const Vector5 scaled_step = damped_step(normal);
    if (!scaled_step.allFinite()) return std::nullopt;
    const double moved_px = scaled_step.tail<3>().cwiseAbs().maxCoeff() / model.amplitude;
    if (step > kMaxSteps) return fit_from(normal, model, Vector5::Zero());
    model = stepped(model, scaled_step);
    if (moved_px < settled_px) return fit_from(normal, model, scaled_step);
  }
}

}  // namespace tripoint
