// Labelled corners of tags as two cameras see them, moved as errors of the tags' edges move them.
#pragma once

#include <array>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "geometry/camera_model.h"
#include "line/model.h"
#include "line/observation.h"
#include "synthetic_cameras.h"

namespace tripoint::testing {

/// A flat square tag of `size_mm` in the target's plane, its centre there.
inline void add_tag(Target& target, int id, double size_mm, const Vec3& centre_mm) {
  TargetTag tag;
  tag.id = id;
  tag.uncertainty_mm = 0.0;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    tag.corners_mm[k] = centre_mm + size_mm / 2.0 * Vec3(kTagCornerPlaces[k][0], kTagCornerPlaces[k][1], 0.0);
  }
  target.points.push_back({id, centre_mm, 0.0, std::nullopt});
  target.tags.push_back(tag);
}

using CornerPlaces = std::array<Vec2, kTagCorners>;
using EdgeErrors = Eigen::Matrix<double, 2 * kTagCorners, 1>;  // across at the middle (px) and angle (rad) of each edge

inline Vec2 meeting(const Vec2& p1, const Vec2& way1, const Vec2& p2, const Vec2& way2) {
  Matrix2 ways;
  ways << way1, -way2;
  return p1 + (ways.inverse() * (p2 - p1)).x() * way1;
}

/// Corners where the edges meet after each was moved and turned a little; edge k runs from corner k to the next.
inline CornerPlaces with_errors(const CornerPlaces& corners, const EdgeErrors& errors) {
  std::array<Vec2, kTagCorners> middles;
  std::array<Vec2, kTagCorners> ways;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec2 way = corners[(k + 1) % kTagCorners] - corners[k];
    const auto at = static_cast<Eigen::Index>(2 * k);
    middles[k] =
        (corners[k] + corners[(k + 1) % kTagCorners]) / 2.0 + errors[at] * Vec2(-way.y(), way.x()).normalized();
    ways[k] = Eigen::Rotation2Dd(errors[at + 1]) * way;
  }
  CornerPlaces moved;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const std::size_t before = (k + kTagCorners - 1) % kTagCorners;
    moved[k] = meeting(middles[before], ways[before], middles[k], ways[k]);
  }
  return moved;
}

struct SeenCorners {
  CornerPlaces places;
  Eigen::Matrix<double, 8, 8> covariance;
};

/// Places along an edge err by a standard deviation that leaves `sigma_px` at its middle: a straight line through them
/// is then known by the root of 12 over the length in its angle.
inline SeenCorners seen_corners(const CornerPlaces& corners, double sigma_px, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  EdgeErrors sigmas;
  EdgeErrors errors;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const double length_px = (corners[(k + 1) % kTagCorners] - corners[k]).norm();
    sigmas.segment<2>(static_cast<Eigen::Index>(2 * k)) << sigma_px, sigma_px * std::sqrt(12.0) / length_px;
  }
  for (Eigen::Index i = 0; i < errors.size(); ++i) errors[i] = sigmas[i] * normal(random);
  Eigen::Matrix<double, 8, 8> slope;
  constexpr double kStep = 1e-5;  // of a central difference
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const CornerPlaces ahead = with_errors(corners, EdgeErrors::Unit(i) * kStep);
    const CornerPlaces behind = with_errors(corners, EdgeErrors::Unit(i) * -kStep);
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      slope.block<2, 1>(static_cast<Eigen::Index>(2 * k), i) = (ahead[k] - behind[k]) / (2.0 * kStep);
    }
  }
  return {with_errors(corners, errors), slope * sigmas.cwiseAbs2().asDiagonal() * slope.transpose()};
}

/// Straight line through the pictures of places along an edge, 2 px from its ends: principal axis of 400 of them.
inline std::pair<Vec2, Vec2> line_along(const std::function<Vec2(double)>& picture_of_share) {
  constexpr int kPlaces = 400;
  const double length_px = (picture_of_share(1.0) - picture_of_share(0.0)).norm();
  Eigen::Matrix<double, 2, kPlaces> places;
  for (int i = 0; i < kPlaces; ++i) {
    places.col(i) = picture_of_share(2.0 / length_px + (1.0 - 4.0 / length_px) * (i + 0.5) / kPlaces);
  }
  const Vec2 middle = places.rowwise().mean();
  const auto off = places.colwise() - middle;
  const Matrix2 scatter = off * off.transpose();
  return {middle, Eigen::SelfAdjointEigenSolver<Matrix2>(scatter).eigenvectors().col(1)};
}

/// Where straight lines along the edges of a tag meet, which a lens bends.
inline CornerPlaces detected(const CameraModel& camera, const std::array<Vec3, kTagCorners>& corners_in_camera) {
  std::array<std::pair<Vec2, Vec2>, kTagCorners> lines;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    lines[k] = line_along([&](double share) -> Vec2 {
      const Vec3& next = corners_in_camera[(k + 1) % kTagCorners];
      const RawPixel pixel = *projected(camera, corners_in_camera[k] + share * (next - corners_in_camera[k]));
      return {pixel.u_px, pixel.v_px};
    });
  }
  CornerPlaces corners;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const auto& before = lines[(k + kTagCorners - 1) % kTagCorners];
    corners[k] = meeting(before.first, before.second, lines[k].first, lines[k].second);
  }
  return corners;
}

/// What one camera sees of the target's tags.
inline void add_tags(Observation& seen, const LineModel& model, const Isometry3& rig_from_target, double sigma_px,
                     std::mt19937_64& random) {
  for (const TargetTag& tag : model.target.tags) {
    std::array<Vec3, kTagCorners> in_camera;
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      in_camera[k] = model.rig.camera_from_rig[seen.side] * (rig_from_target * tag.corners_mm[k]);
    }
    const CornerPlaces corners = detected(model.rig.cameras[seen.side], in_camera);
    const SeenCorners found = seen_corners(corners, sigma_px, random);
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      const auto at = static_cast<Eigen::Index>(2 * k);
      const auto next = static_cast<Eigen::Index>(2 * ((k + 1) % kTagCorners));
      ImagePoint point;
      point.at = {found.places[k].x(), found.places[k].y()};
      point.covariance_px2 = found.covariance.block<2, 2>(at, at);
      point.shared_with_next_px2 = found.covariance.block<2, 2>(at, next);
      point.label = PointLabel{tag.id, static_cast<int>(k)};
      seen.points.push_back(point);
    }
  }
}

}  // namespace tripoint::testing
