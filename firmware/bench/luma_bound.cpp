#include "bench/luma_bound.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace tripoint::bench {
namespace {

constexpr int kSide_px = 23;               // of the luma window: six sigma of a spot of 1.9 px to each side
constexpr int kRawSide_px = kSide_px + 2;  // demosaicing looks one pixel further
constexpr int kLumas = kSide_px * kSide_px;
constexpr int kRaws = kRawSide_px * kRawSide_px;
constexpr int kPhases = 4;  // places tried along each axis of the mosaic's cell of 2 px
constexpr double kRounding = 1.0 / 12.0;

// A small CMOS pixel; the amplifier's gain lowers the number of electrons at which the converter clips.
constexpr double kFullWell_electrons = 8000.0;
constexpr double kReadNoise_electrons = 4.0;

/// Luma steps for a channel at clip. Source: ITU-R BT.601-7, section 2.5.1.
constexpr LinearColor kLumaOf{65.481, 128.553, 24.966};

/// Share of a neighbour's count in the interpolated value of channel `wanted` at (x, y); bilinear.
double bilinear_share(std::size_t wanted, int x, int y, int dx, int dy) {
  if (bayer_channel(x + dx, y + dy) != wanted) return 0.0;
  const std::size_t own = bayer_channel(x, y);
  if (own == wanted) return dx == 0 && dy == 0 ? 1.0 : 0.0;
  if (wanted == 1) return std::abs(dx) + std::abs(dy) == 1 ? 0.25 : 0.0;
  if (own == 1) return std::abs(dx) + std::abs(dy) == 1 ? 0.5 : 0.0;
  return std::abs(dx) == 1 && std::abs(dy) == 1 ? 0.25 : 0.0;
}

/// Luma of the window from the levels under the mosaic, which starts one pixel earlier.
Eigen::MatrixXd luma_from_raw() {
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(kLumas, kRaws);
  for (int y = 0; y < kSide_px; ++y) {
    for (int x = 0; x < kSide_px; ++x) {
      for (int k = 0; k < 9; ++k) {
        const int dx = k % 3 - 1;
        const int dy = k / 3 - 1;
        double weight = 0.0;
        for (std::size_t c = 0; c < 3; ++c) weight += kLumaOf[c] * bilinear_share(c, x + 1, y + 1, dx, dy);
        map(y * kSide_px + x, (y + 1 + dy) * kRawSide_px + x + 1 + dx) += weight;
      }
    }
  }
  return map;
}

/// Share of a Gaussian's energy in a pixel; at a distance in px.
double pixel_share(double distance_px, double sigma_px) {
  const double scale = 1.0 / (sigma_px * std::numbers::sqrt2);
  return 0.5 * (std::erf((distance_px + 0.5) * scale) - std::erf((distance_px - 0.5) * scale));
}

/// Mean level of each pixel under the mosaic, of the light alone, centred in the window but for `offset_px`.
Eigen::VectorXd light_levels(const LightTruth& spot, const LightSource& light, const Vec2& offset_px) {
  Eigen::VectorXd levels = Eigen::VectorXd::Zero(kRaws);
  const double sigma_px = spot.core_sigma_px;
  const double middle_px = (kRawSide_px - 1) / 2.0;
  for (int i = 0; i < kRaws; ++i) {
    const int x = i % kRawSide_px;
    const int y = i / kRawSide_px;
    const double dx = x - middle_px - offset_px.x();
    const double dy = y - middle_px - offset_px.y();
    for (const auto& [share, widening] : {std::pair{1.0, 1.0}, std::pair{light.halo_share, light.halo_widening}}) {
      const double width_px = widening * sigma_px;
      const double energy = 2.0 * std::numbers::pi * width_px * width_px * spot.peak * share;
      levels[i] += energy * light.color[bayer_channel(x, y)] * pixel_share(dx, width_px) * pixel_share(dy, width_px);
    }
  }
  return levels;
}

/// Variances of u and v, px^2, for a spot at one place of the mosaic.
Vec2 bounds_px2(const SensorModel& sensor, const LightTruth& spot, const LightSource& light,
                const LinearColor& background, const Vec2& offset_px) {
  constexpr double kStep_px = 1e-4;
  static const Eigen::MatrixXd luma_of = luma_from_raw();
  const Eigen::VectorXd levels = light_levels(spot, light, offset_px);
  Eigen::VectorXd variance(kRaws);
  for (int i = 0; i < kRaws; ++i) {
    const double level = levels[i] + background[bayer_channel(i % kRawSide_px, i / kRawSide_px)];
    variance[i] = sensor.read_noise * sensor.read_noise + level / sensor.full_well_electrons;
  }
  Eigen::MatrixXd covariance = luma_of * variance.asDiagonal() * luma_of.transpose();
  covariance.diagonal().array() += kRounding;
  const auto slope = [&](const Vec2& axis) -> Eigen::VectorXd {
    const Vec2 step_px = kStep_px * axis;
    return luma_of * (light_levels(spot, light, offset_px + step_px) - light_levels(spot, light, offset_px - step_px)) /
           (2.0 * kStep_px);
  };
  Eigen::Matrix<double, kLumas, 4> jacobian;
  jacobian.col(0) = slope(Vec2::UnitX());
  jacobian.col(1) = slope(Vec2::UnitY());
  jacobian.col(2) = luma_of * levels;               // amplitude
  jacobian.col(3) = Eigen::VectorXd::Ones(kLumas);  // background
  const Eigen::Matrix4d information = jacobian.transpose() * covariance.llt().solve(jacobian);
  return information.inverse().diagonal().head<2>();
}

}  // namespace

double luma_bound_px(const SensorModel& sensor, const LightTruth& spot, const LightSource& light,
                     const LinearColor& background) {
  double sum_px2 = 0.0;
  for (int i = 0; i < kPhases * kPhases; ++i) {
    const Vec2 offset_px = Vec2(i % kPhases, i / kPhases) * (2.0 / kPhases) - Vec2(1.0, 1.0);
    sum_px2 += bounds_px2(sensor, spot, light, background, offset_px).mean();
  }
  return std::sqrt(sum_px2 / (kPhases * kPhases));
}

LinearColor wall_level(const Scene& scene) {
  LinearColor level{};
  for (std::size_t c = 0; c < level.size(); ++c) level[c] = scene.white_level * scene.surfaces[0].reflectance[c];
  return level;
}

SensorModel sensor_with_bound(double bound_px, const LightTruth& spot, const LightSource& light,
                              const LinearColor& background) {
  constexpr int kHalvings = 14;
  double low = 1.0;
  double high = 400.0;
  SensorModel sensor;
  for (int i = 0; i < kHalvings; ++i) {
    const double gain = std::sqrt(low * high);
    sensor.read_noise = kReadNoise_electrons * gain / kFullWell_electrons;
    sensor.full_well_electrons = kFullWell_electrons / gain;
    (luma_bound_px(sensor, spot, light, background) < bound_px ? low : high) = gain;
  }
  return sensor;
}

}  // namespace tripoint::bench
