// Short names for the fixed-size linear algebra that every room uses. Fixed size: no allocation.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tripoint {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Matrix2 = Eigen::Matrix2d;
using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Isometry3 = Eigen::Isometry3d;  ///< a rigid transform, named target_from_source

/// The matrix of a cross product: cross_matrix(v) w = v x w.
inline Matrix3 cross_matrix(const Vec3& v) {
  Matrix3 m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace tripoint
