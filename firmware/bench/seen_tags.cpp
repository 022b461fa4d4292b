#include "bench/seen_tags.h"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace tripoint::bench {
namespace {

using EdgeErrors = Eigen::Matrix<double, 2 * kTagCorners, 1>;  // across at the middle (px) and angle (rad) of each edge

Vec2 meeting(const Vec2& p1, const Vec2& way1, const Vec2& p2, const Vec2& way2) {
  Matrix2 ways;
  ways << way1, -way2;
  return p1 + (ways.inverse() * (p2 - p1)).x() * way1;
}

/// Edge k runs from corner k to the next.
CornerPlaces moved_by(const EdgeErrors& errors, const CornerPlaces& corners) {
  CornerPlaces middles;
  CornerPlaces ways;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec2& next = corners[(k + 1) % kTagCorners];
    const Vec2 way = next - corners[k];
    const auto at = static_cast<Eigen::Index>(2 * k);
    middles[k] = (corners[k] + next) / 2.0 + errors[at] * Vec2(-way.y(), way.x()).normalized();
    ways[k] = Eigen::Rotation2Dd(errors[at + 1]) * way;
  }
  CornerPlaces moved;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const std::size_t before = (k + kTagCorners - 1) % kTagCorners;
    moved[k] = meeting(middles[before], ways[before], middles[k], ways[k]);
  }
  return moved;
}

/// Straight line through the pictures of places along an edge, 2 px from its ends: principal axis of 100 of them.
std::pair<Vec2, Vec2> line_along(const CameraModel& camera, const Vec3& from, const Vec3& to) {
  constexpr int kPlaces = 100;
  const auto picture = [&](double share) -> Vec2 {
    const RawPixel pixel = *projected(camera, from + share * (to - from));
    return {pixel.u_px, pixel.v_px};
  };
  const double length_px = (picture(1.0) - picture(0.0)).norm();
  Eigen::Matrix<double, 2, kPlaces> places;
  for (int i = 0; i < kPlaces; ++i)
    places.col(i) = picture(2.0 / length_px + (1.0 - 4.0 / length_px) * (i + 0.5) / kPlaces);
  const Vec2 middle = places.rowwise().mean();
  const auto off = places.colwise() - middle;
  const Matrix2 scatter = off * off.transpose();
  return {middle, Eigen::SelfAdjointEigenSolver<Matrix2>(scatter).eigenvectors().col(1)};
}

}  // namespace

void add_tag(Target& target, int id, double size_mm, const Vec3& centre_mm, double uncertainty_mm) {
  TargetTag tag;
  tag.id = id;
  tag.uncertainty_mm = uncertainty_mm;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    tag.corners_mm[k] = centre_mm + size_mm / 2.0 * Vec3(kTagCornerPlaces[k][0], kTagCornerPlaces[k][1], 0.0);
  }
  target.points.push_back({id, centre_mm, uncertainty_mm, std::nullopt});
  target.tags.push_back(tag);
}

CornerPlaces meetings_of_edges(const CameraModel& camera, const std::array<Vec3, kTagCorners>& corners_in_camera) {
  std::array<std::pair<Vec2, Vec2>, kTagCorners> lines;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    lines[k] = line_along(camera, corners_in_camera[k], corners_in_camera[(k + 1) % kTagCorners]);
  }
  CornerPlaces corners;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const auto& before = lines[(k + kTagCorners - 1) % kTagCorners];
    corners[k] = meeting(before.first, before.second, lines[k].first, lines[k].second);
  }
  return corners;
}

SeenCorners with_edge_errors(const CornerPlaces& corners, double sigma_px, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  EdgeErrors sigmas;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const double length_px = (corners[(k + 1) % kTagCorners] - corners[k]).norm();
    sigmas.segment<2>(static_cast<Eigen::Index>(2 * k)) << sigma_px, sigma_px * std::sqrt(12.0) / length_px;
  }
  const EdgeErrors errors = sigmas.cwiseProduct(EdgeErrors::NullaryExpr([&] { return normal(random); }));
  CornerSpread slope;
  constexpr double kStep = 1e-5;  // of a central difference
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const CornerPlaces ahead = moved_by(EdgeErrors::Unit(i) * kStep, corners);
    const CornerPlaces behind = moved_by(EdgeErrors::Unit(i) * -kStep, corners);
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      slope.block<2, 1>(static_cast<Eigen::Index>(2 * k), i) = (ahead[k] - behind[k]) / (2.0 * kStep);
    }
  }
  return {moved_by(errors, corners), slope * sigmas.cwiseAbs2().asDiagonal() * slope.transpose()};
}

void add_tags(Observation& seen, const LineModel& model, const Isometry3& rig_from_target, const TagErrors& errors,
              std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (const TargetTag& tag : model.target.tags) {
    std::array<Vec3, kTagCorners> in_camera;
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      in_camera[k] = model.rig.camera_from_rig[seen.side] * (rig_from_target * tag.corners_mm[k]);
    }
    const SeenCorners found =
        with_edge_errors(meetings_of_edges(model.rig.cameras[seen.side], in_camera), errors.edge_px, random);
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      const auto at = static_cast<Eigen::Index>(2 * k);
      const auto next = static_cast<Eigen::Index>(2 * ((k + 1) % kTagCorners));
      ImagePoint point;
      point.at = {found.places[k].x(), found.places[k].y()};
      if (errors.corner_px > 0.0) {
        point.at.u_px += errors.corner_px * normal(random);
        point.at.v_px += errors.corner_px * normal(random);
      }
      point.covariance_px2 =
          found.covariance.block<2, 2>(at, at) + errors.corner_px * errors.corner_px * Matrix2::Identity();
      point.shared_with_next_px2 = found.covariance.block<2, 2>(at, next);
      point.label = PointLabel{tag.id, static_cast<int>(k)};
      seen.points.push_back(point);
    }
  }
}

}  // namespace tripoint::bench
