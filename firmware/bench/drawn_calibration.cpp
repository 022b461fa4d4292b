#include "bench/drawn_calibration.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/triangulation.h"
#include "values/assert.h"

namespace tripoint::bench {
namespace {

constexpr int kBoardViews = 40;
constexpr int kWandFrames = 500;
constexpr std::uint64_t kDrawSeed = 20;

using Row24 = Eigen::Matrix<double, 4, 24>;
using PointParameters = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// One point of a view: where it is in the left camera's frame, and how the pose of the view moves it.
struct ViewPoint {
  Vec3 in_left_mm;
  PointParameters by_pose;
};
using View = std::vector<ViewPoint>;

using Pixels = Eigen::Matrix<double, 4, 1>;

/// Both pictures of a point; nothing when it is outside of one.
std::optional<Pixels> pixels_of(const StereoCalibration& calibration, const Vec3& in_left_mm) {
  Pixels pixels;
  for (const Side side : kBothSides) {
    const CameraModel& camera = calibration.cameras[side];
    const Vec3 in_camera_mm = side == Side::kLeft ? in_left_mm : calibration.right_from_left * in_left_mm;
    const Result<RawPixel> at = projected(camera, in_camera_mm);
    if (!at || at->u_px < 0.0 || at->v_px < 0.0 || at->u_px > camera.size.width_px - 1.0 ||
        at->v_px > camera.size.height_px - 1.0) {
      return std::nullopt;
    }
    pixels.segment<2>(side == Side::kLeft ? 0 : 2) = Vec2(at->u_px, at->v_px);
  }
  return pixels;
}

/// Steps of a difference quotient for fx fy cx cy k1 k2 p1 p2 k3 (twice), rotation, translation.
RigParameters parameter_steps() {
  RigParameters steps;
  steps.setConstant(1e-5);
  for (const int camera : {0, 9}) steps.segment<4>(camera).setConstant(1e-3);
  steps.tail<3>().setConstant(1e-3);
  return steps;
}

std::optional<Row24> jacobian_by_parameters(const StereoCalibration& truth, const Vec3& in_left_mm) {
  const PerSide<ImageSize> sizes{truth.cameras.left.size, truth.cameras.right.size};
  const RigParameters parameters = parameters_of(truth);
  const RigParameters steps = parameter_steps();
  Row24 jacobian;
  for (int i = 0; i < 24; ++i) {
    const RigParameters step = RigParameters::Unit(i) * steps[i];
    const std::optional<Pixels> more = pixels_of(calibration_of(parameters + step, sizes), in_left_mm);
    const std::optional<Pixels> less = pixels_of(calibration_of(parameters - step, sizes), in_left_mm);
    if (!more || !less) return std::nullopt;
    jacobian.col(i) = (*more - *less) / (2.0 * steps[i]);
  }
  return jacobian;
}

Eigen::Matrix<double, 4, 3> jacobian_by_place(const StereoCalibration& truth, const Vec3& in_left_mm) {
  Eigen::Matrix<double, 4, 3> jacobian;
  jacobian.topRows<2>() = projection_jacobian_px_per_mm(truth.cameras.left, in_left_mm);
  jacobian.bottomRows<2>() = projection_jacobian_px_per_mm(truth.cameras.right, truth.right_from_left * in_left_mm) *
                             truth.right_from_left.linear();
  return jacobian;
}

class Views {
 public:
  explicit Views(std::uint64_t seed) : random_(seed) {}

  View board() {
    const Vec3 center(between(-70.0, 110.0), between(-70.0, 70.0), between(300.0, 500.0));
    const double tilt_rad = between(20.0, 45.0) * std::numbers::pi / 180.0;
    const double way_rad = between(0.0, 2.0 * std::numbers::pi);
    const Vec3 axis(std::cos(way_rad), std::sin(way_rad), 0.0);
    const Matrix3 rotation =
        (Eigen::AngleAxisd(between(-0.5, 0.5), Vec3::UnitZ()) * Eigen::AngleAxisd(tilt_rad, axis)).toRotationMatrix();
    View view;
    for (int i = 0; i < 54; ++i) {
      const Vec3 arm = rotation * Vec3(24.0 * (i % 9 - 4), 24.0 * (i / 9 - 2.5), 0.0);
      PointParameters by_pose(3, 6);
      by_pose << Matrix3::Identity(), -cross_matrix(arm);
      view.push_back({.in_left_mm = center + arm, .by_pose = by_pose});
    }
    return view;
  }

  View wand() {
    const Vec3 center(between(-120.0, 160.0), between(-130.0, 130.0), between(300.0, 500.0));
    const Vec3 along = Vec3(normal_(random_), normal_(random_), normal_(random_)).normalized();
    const Vec3 across = along.unitOrthogonal();
    const Vec3 other = along.cross(across);
    View view;
    for (const double place_mm : {-93.0, -13.0, 107.0}) {  // 0, 80 and 200 mm, about their middle
      PointParameters by_pose(3, 5);
      by_pose << Matrix3::Identity(), place_mm * across, place_mm * other;
      view.push_back({.in_left_mm = center + place_mm * along, .by_pose = by_pose});
    }
    return view;
  }

 private:
  double between(double low, double high) { return low + (high - low) * uniform_(random_); }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
  std::normal_distribution<double> normal_;
};

/// What a view says about the calibration when its own pose is unknown (Schur complement), for 1 px of noise.
/// @return nothing when fewer points are seen by both cameras than its pose needs, or a wand is not seen whole
std::optional<RigCovariance> information_of(const StereoCalibration& truth, const View& view) {
  const Eigen::Index pose_size = view.front().by_pose.cols();
  RigCovariance calibration = RigCovariance::Zero();
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(24, pose_size);
  Eigen::MatrixXd pose = Eigen::MatrixXd::Zero(pose_size, pose_size);
  std::size_t seen = 0;
  for (const ViewPoint& point : view) {
    if (!pixels_of(truth, point.in_left_mm)) continue;
    const std::optional<Row24> by_parameters = jacobian_by_parameters(truth, point.in_left_mm);
    if (!by_parameters) continue;
    const Eigen::MatrixXd by_pose = jacobian_by_place(truth, point.in_left_mm) * point.by_pose;
    calibration += by_parameters->transpose() * *by_parameters;
    mixed += by_parameters->transpose() * by_pose;
    pose += by_pose.transpose() * by_pose;
    ++seen;
  }
  const bool enough = view.size() == 3 ? seen == 3 : seen >= 12;
  if (!enough) return std::nullopt;
  return calibration - mixed * pose.ldlt().solve(mixed.transpose());
}

/// Noise-free places seen with the true rig and measured with a drawn one; both in their own reference frames.
DrawnCalibration registered(const StereoCalibration& drawn, const Rig& truth, const std::vector<Vec3>& places_mm) {
  const Result<Rig> rig = rig_of(drawn);
  TRIPOINT_ASSERT(rig);
  const auto count = static_cast<Eigen::Index>(places_mm.size());
  Eigen::Matrix3Xd measured(3, count);
  Eigen::Matrix3Xd expected(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    expected.col(i) = places_mm[static_cast<std::size_t>(i)];
    PerSide<MeasuredPixel> seen;
    for (const Side side : kBothSides) {
      const Vec3 in_camera_mm = truth.camera_from_rig[side] * expected.col(i);
      seen[side].at = projected(truth.cameras[side], in_camera_mm).value();
    }
    measured.col(i) = triangulated(*rig, seen).value().in_rig_mm;
  }
  DrawnCalibration result{.calibration = drawn, .rig = *rig};
  result.truth_from_drawn.matrix() = Eigen::umeyama(measured, expected, false);
  const Eigen::Matrix3Xd moved =
      (result.truth_from_drawn.linear() * measured).colwise() + result.truth_from_drawn.translation();
  result.field_rms_mm = std::sqrt((moved - expected).squaredNorm() / static_cast<double>(count));
  return result;
}

}  // namespace

RigCovariance adjustment_covariance(const StereoCalibration& truth, double sigma_px, std::uint64_t seed) {
  Views views(seed);
  RigCovariance information = RigCovariance::Zero();
  for (int taken = 0; taken < kBoardViews + kWandFrames;) {
    const std::optional<RigCovariance> more = information_of(truth, taken < kBoardViews ? views.board() : views.wand());
    if (!more) continue;
    information += *more;
    ++taken;
  }
  // The parameters differ by many powers of ten: scaled to unit diagonal before inverting.
  const RigParameters scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const RigCovariance even = scale.asDiagonal() * information * scale.asDiagonal();
  const RigCovariance inverse = even.ldlt().solve(RigCovariance::Identity());
  return sigma_px * sigma_px * (scale.asDiagonal() * inverse * scale.asDiagonal());
}

std::vector<DrawnCalibration> drawn_calibrations(const StereoCalibration& truth, const RigCovariance& covariance,
                                                 const std::vector<Vec3>& places_mm, double field_rms_mm, int count) {
  const Rig rig = rig_of(truth).value();
  const PerSide<ImageSize> sizes{truth.cameras.left.size, truth.cameras.right.size};
  const RigParameters scale = covariance.diagonal().cwiseSqrt();
  const RigCovariance correlation = scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  const RigCovariance root = correlation.llt().matrixL();
  const auto draw_all = [&](double size) {
    std::mt19937_64 random(kDrawSeed);
    std::normal_distribution<double> normal;
    std::vector<DrawnCalibration> drawn;
    for (int i = 0; i < count; ++i) {
      RigParameters white;
      for (double& value : white) value = normal(random);
      const RigParameters error = size * scale.cwiseProduct(root * white);
      drawn.push_back(registered(calibration_of(parameters_of(truth) + error, sizes), rig, places_mm));
    }
    return drawn;
  };
  double squares_mm2 = 0.0;
  for (const DrawnCalibration& drawn : draw_all(1.0)) squares_mm2 += drawn.field_rms_mm * drawn.field_rms_mm;
  const double unscaled_mm = std::sqrt(squares_mm2 / count);
  std::fprintf(stderr, "calibration: field %.4f mm RMS as adjusted, scaled to %.4f\n", unscaled_mm, field_rms_mm);
  return draw_all(field_rms_mm / unscaled_mm);
}

}  // namespace tripoint::bench
