#include "sim/spot.h"

#include <algorithm>
#include <cmath>

#include "sim/sensor.h"

namespace tripoint {
namespace {

constexpr double kReachSigmas = 5.0;  // beyond it a Gaussian is under 4e-6 of its peak
constexpr double kRowVariance_px2 = 1.0 / 12.0;

}  // namespace

/// An elliptic Gaussian row by row: the row's share of the energy, then a Gaussian along the row whose centre leans.
struct LightPlane::Axes {
  double sigma_u_px;  ///< within a row
  double sigma_v_px;
  double lean = 0.0;  ///< by which the centre moves from row to row

  static Axes of(const GaussianSpot& spot) {
    if (spot.elongation == 1.0) return {.sigma_u_px = spot.sigma_px, .sigma_v_px = spot.sigma_px};
    const Matrix2 turn = Eigen::Rotation2Dd(spot.elongation_angle_rad).toRotationMatrix();
    const Vec2 variances = spot.sigma_px * spot.sigma_px * Vec2(spot.elongation, 1.0 / spot.elongation);
    const Matrix2 covariance = turn * variances.asDiagonal() * turn.transpose();
    // What a row holds comes from all its height: the mean of it leans less than a line at its middle would.
    const double lean = covariance(0, 1) / (covariance(1, 1) + kRowVariance_px2);
    return {.sigma_u_px = std::sqrt(covariance(0, 0) - lean * covariance(0, 1)),
            .sigma_v_px = std::sqrt(covariance(1, 1)),
            .lean = lean};
  }
};

LightPlane::LightPlane(ImageSize size, std::span<const float> background)
    : size_(size),
      background_(background),
      levels_(background.begin(), background.end()),
      first_touched_(size.height_px) {}

void LightPlane::add(const GaussianSpot& spot, const NormalIntegral& normal, std::span<const Mask> masks) {
  const Axes axes = Axes::of(spot);
  // A spot that moves with the rows is stretched over more or fewer of them.
  const double stretch = 1.0 / std::max(1.0 - spot.shift_px_per_row.y(), 0.1);
  const double reach_px = kReachSigmas * axes.sigma_v_px * stretch + 1.0;
  const double top = std::max(std::floor(spot.at.v_px - reach_px), 0.0);
  const double bottom = std::min(std::ceil(spot.at.v_px + reach_px), size_.height_px - 1.0);
  if (!(top <= bottom)) return;
  for (int y = static_cast<int>(top); y <= static_cast<int>(bottom); ++y) add_to_row(y, spot, axes, normal, masks);
  first_touched_ = std::min(first_touched_, static_cast<int>(top));
  last_touched_ = std::max(last_touched_, static_cast<int>(bottom));
}

void LightPlane::add_to_row(int y, const GaussianSpot& spot, const Axes& axes, const NormalIntegral& normal,
                            std::span<const Mask> masks) {
  const Vec2 moved_px = spot.shift_px_per_row * (y - spot.row_px);
  const double v_px = spot.at.v_px + moved_px.y();
  const double u_px = spot.at.u_px + moved_px.x() + axes.lean * (y - v_px);
  const double left = std::max(std::floor(u_px - kReachSigmas * axes.sigma_u_px), 0.0);
  const double right = std::min(std::ceil(u_px + kReachSigmas * axes.sigma_u_px), size_.width_px - 1.0);
  const auto per_sigma = static_cast<float>(1.0 / axes.sigma_u_px);
  const auto above = static_cast<float>((y - 0.5 - v_px) / axes.sigma_v_px);
  const float share = normal(above + static_cast<float>(1.0 / axes.sigma_v_px)) - normal(above);
  if (!(left <= right) || share <= 0.0F) return;
  const float even = share * static_cast<float>(spot.energy[bayer_channel(0, y)]);
  const float odd = share * static_cast<float>(spot.energy[bayer_channel(1, y)]);
  float* levels = levels_.data() + static_cast<std::ptrdiff_t>(y) * size_.width_px;
  const auto start = static_cast<float>((left - 0.5 - u_px) / axes.sigma_u_px);
  float before = normal(start);
  const int first = static_cast<int>(left);
  for (int x = first; x <= static_cast<int>(right); ++x) {
    const float after = normal(start + static_cast<float>(x - first + 1) * per_sigma);
    const float passed = masks.empty() ? 1.0F : static_cast<float>(passed_share(masks, x, y, normal));
    levels[x] += (after - before) * ((x & 1) != 0 ? odd : even) * passed;
    before = after;
  }
}

std::span<float> LightPlane::painted_row(int y) {
  first_touched_ = std::min(first_touched_, y);
  last_touched_ = std::max(last_touched_, y);
  const auto width = static_cast<std::size_t>(size_.width_px);
  return std::span(levels_).subspan(static_cast<std::size_t>(y) * width, width);
}

void LightPlane::clear() {
  if (last_touched_ < first_touched_) return;
  const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(first_touched_) * size_.width_px;
  const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(last_touched_ + 1) * size_.width_px;
  std::copy(background_.begin() + begin, background_.begin() + end, levels_.begin() + begin);
  first_touched_ = size_.height_px;
  last_touched_ = -1;
}

std::span<const float> LightPlane::row(int y) const {
  const auto width = static_cast<std::size_t>(size_.width_px);
  return std::span(levels_).subspan(static_cast<std::size_t>(y) * width, width);
}

}  // namespace tripoint
