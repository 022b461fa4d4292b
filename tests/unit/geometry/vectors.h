// The published vectors (tests/vectors/paper_equations.json) as values.
#pragma once

#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "places.h"

namespace tripoint::testing {

inline nlohmann::json vectors(const std::string& name) {
  std::ifstream file{test::top_folder() / "tests/vectors/paper_equations.json"};
  return nlohmann::json::parse(file).at(name);
}

/// A copy of one part: a reference into `vectors(name)` would outlive it in a range-based for.
inline nlohmann::json vectors(const std::string& name, const std::string& part) { return vectors(name).at(part); }

inline double number(const nlohmann::json& j) { return j.get<double>(); }
inline Vec2 vec2(const nlohmann::json& x, const nlohmann::json& y) { return {number(x), number(y)}; }
inline Vec3 vec3(const nlohmann::json& j) { return {number(j.at(0)), number(j.at(1)), number(j.at(2))}; }
inline RawPixel pixel(const nlohmann::json& j) { return {number(j.at(0)), number(j.at(1))}; }

inline Matrix3 matrix3(const nlohmann::json& j) {
  Matrix3 matrix;
  for (int row = 0; row < 3; ++row) matrix.row(row) = vec3(j.at(static_cast<std::size_t>(row)));
  return matrix;
}

inline CameraModel camera(const nlohmann::json& j) {
  const auto& k = j.at("K");
  CameraModel camera{{640, 480}, vec2(k[0][0], k[1][1]), vec2(k[0][2], k[1][2]), {}};
  for (std::size_t i = 0; i < 5; ++i) camera.distortion[i] = number(j.at("distortion_k1k2p1p2k3")[i]);
  return camera;
}

/// The rig of vectors E: what a pair of webcams looks like after calibration.
inline StereoCalibration general_calibration() {
  const nlohmann::json e = vectors("E_general_model");
  StereoCalibration calibration;
  calibration.cameras = {camera(e.at("left")), camera(e.at("right"))};
  calibration.right_from_left.linear() = matrix3(e.at("right_from_left").at("rotation"));
  calibration.right_from_left.translation() = vec3(e.at("right_from_left").at("translation_mm"));
  return calibration;
}

inline Rig general_rig() { return rig_of(general_calibration()).value(); }

/// Two equal cameras without distortion, axes parallel.
inline StereoCalibration parallel_calibration(double focal_px, double baseline_mm) {
  StereoCalibration calibration;
  const CameraModel camera{{640, 480}, {focal_px, focal_px}, {320.0, 240.0}, {}};
  calibration.cameras = {camera, camera};
  calibration.right_from_left.translation() = Vec3{-baseline_mm, 0.0, 0.0};
  return calibration;
}

inline Rig parallel_rig(double focal_px, double baseline_mm) {
  return rig_of(parallel_calibration(focal_px, baseline_mm)).value();
}

/// Both pictures of a point, each with a round covariance.
inline PerSide<MeasuredPixel> seen_exactly(const Rig& rig, const Vec3& point_in_rig, double sigma_px = 1.0) {
  const Matrix2 covariance = sigma_px * sigma_px * Matrix2::Identity();
  return {{projected(rig.cameras.left, rig.camera_from_rig.left * point_in_rig).value(), covariance},
          {projected(rig.cameras.right, rig.camera_from_rig.right * point_in_rig).value(), covariance}};
}

}  // namespace tripoint::testing
