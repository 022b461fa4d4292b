#include "sim/spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/sensor.h"

namespace tripoint {
namespace {

constexpr double kReachSigmas = 5.0;  // beyond it a Gaussian is under 4e-6 of its peak

}  // namespace

NormalIntegral::NormalIntegral() {
  constexpr int kCount = static_cast<int>(2.0F * kReach) * kStepsPerUnit + 1;
  values_.reserve(kCount);
  for (int i = 0; i < kCount; ++i) {
    const double z = static_cast<double>(i) / kStepsPerUnit - static_cast<double>(kReach);
    values_.push_back(static_cast<float>(0.5 * std::erfc(-z / std::numbers::sqrt2)));
  }
}

LightPlane::LightPlane(ImageSize size, std::span<const float> background)
    : size_(size),
      background_(background),
      levels_(background.begin(), background.end()),
      first_touched_(size.height_px) {}

void LightPlane::add(const GaussianSpot& spot, const NormalIntegral& normal) {
  // A spot that moves with the rows is stretched over more or fewer of them.
  const double stretch = 1.0 / std::max(1.0 - spot.shift_px_per_row.y(), 0.1);
  const double reach_px = kReachSigmas * spot.sigma_px * stretch + 1.0;
  const double top = std::max(std::floor(spot.at.v_px - reach_px), 0.0);
  const double bottom = std::min(std::ceil(spot.at.v_px + reach_px), size_.height_px - 1.0);
  if (!(top <= bottom)) return;
  for (int y = static_cast<int>(top); y <= static_cast<int>(bottom); ++y) add_to_row(y, spot, normal);
  first_touched_ = std::min(first_touched_, static_cast<int>(top));
  last_touched_ = std::max(last_touched_, static_cast<int>(bottom));
}

void LightPlane::add_to_row(int y, const GaussianSpot& spot, const NormalIntegral& normal) {
  const Vec2 moved_px = spot.shift_px_per_row * (y - spot.row_px);
  const double u_px = spot.at.u_px + moved_px.x();
  const double v_px = spot.at.v_px + moved_px.y();
  const double left = std::max(std::floor(u_px - kReachSigmas * spot.sigma_px), 0.0);
  const double right = std::min(std::ceil(u_px + kReachSigmas * spot.sigma_px), size_.width_px - 1.0);
  const auto per_sigma = static_cast<float>(1.0 / spot.sigma_px);
  const auto above = static_cast<float>((y - 0.5 - v_px) / spot.sigma_px);
  const float share = normal(above + per_sigma) - normal(above);
  if (!(left <= right) || share <= 0.0F) return;
  const float even = share * static_cast<float>(spot.energy[bayer_channel(0, y)]);
  const float odd = share * static_cast<float>(spot.energy[bayer_channel(1, y)]);
  float* levels = levels_.data() + static_cast<std::ptrdiff_t>(y) * size_.width_px;
  const auto start = static_cast<float>((left - 0.5 - u_px) / spot.sigma_px);
  float before = normal(start);
  const int first = static_cast<int>(left);
  for (int x = first; x <= static_cast<int>(right); ++x) {
    const float after = normal(start + static_cast<float>(x - first + 1) * per_sigma);
    levels[x] += (after - before) * ((x & 1) != 0 ? odd : even);
    before = after;
  }
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
