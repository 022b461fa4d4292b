#include "bench/erring_units.h"

#include <Eigen/Cholesky>

#include "bench/drawn_calibration.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kAdjustmentSeed = 1;

}  // namespace

LineModel model_of(std::span<const Vec3> leds_mm, const StereoCalibration& calibration, const RigCovariance& spread,
                   double target_mm) {
  LineModel model;
  model.calibration = calibration;
  model.rig = rig_of(calibration).value();
  model.covariance = spread;
  model.volume = WorkingVolume{{-300.0, -300.0, 150.0}, {300.0, 300.0, 800.0}};
  for (const Vec3& led : leds_mm) {
    model.target.points.push_back({static_cast<int>(model.target.points.size()) + 1, led, 2.0 * target_mm});
  }
  return model;
}

ErringUnits::ErringUnits(const StereoCalibration& truth, const ErrorSources& sources)
    : truth_(truth), sources_(sources) {
  if (sources.calibration_px == 0.0) return;
  covariance_ = adjustment_covariance(truth, sources.calibration_px, kAdjustmentSeed);
  scale_ = covariance_.diagonal().cwiseSqrt();
  const RigParameters inverse = scale_.cwiseInverse();
  root_ = RigCovariance(inverse.asDiagonal() * covariance_ * inverse.asDiagonal()).llt().matrixL();
}

LineModel ErringUnits::model(std::span<const Vec3> leds_mm, std::mt19937_64& random) const {
  std::normal_distribution<double> normal;
  RigParameters white;
  for (double& value : white) value = normal(random);
  const PerSide<ImageSize> sizes{truth_.cameras.left.size, truth_.cameras.right.size};
  const StereoCalibration drawn = calibration_of(parameters_of(truth_) + scale_.cwiseProduct(root_ * white), sizes);
  return model_of(leds_mm, drawn, covariance_, sources_.target_mm);
}

std::vector<Vec3> ErringUnits::target(std::span<const Vec3> leds_mm, std::mt19937_64& random) const {
  std::normal_distribution<double> normal;
  std::vector<Vec3> made_mm;
  for (const Vec3& led_mm : leds_mm) {
    made_mm.emplace_back(led_mm + sources_.target_mm * Vec3::NullaryExpr([&] { return normal(random); }));
  }
  return made_mm;
}

Aligned as_seen(const TargetView& view, double sigma_px) {
  Aligned seen;
  seen.due = seen.common_time = true;
  for (const Side side : kBothSides) {
    for (const ViewedSpot& spot : view.spots[side]) {
      AlignedPoint point;
      point.seen.at = spot.at;
      point.seen.covariance_px2 = sigma_px * sigma_px * Matrix2::Identity();
      seen.points[side].push_back(point);
      ++seen.spots[side];
    }
  }
  return seen;
}

}  // namespace tripoint::bench
