#include "line/pose/pixel_rows.h"

#include "geometry/triangulation.h"

namespace tripoint {

std::span<const LocatedPoint> part_from(std::span<const LocatedPoint> points, std::size_t first) {
  return points.subspan(first, points[first].next ? kTagCorners : 1);
}

PixelCovariance spots_covariance_px2(std::span<const LocatedPoint> part) {
  PixelCovariance covariance = PixelCovariance::Zero(row_of(part.size()), row_of(part.size()));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const LocatedPoint& point = part[i];
    for (const Side side : kBothSides) {
      const Eigen::Index row = row_of(i) + first_row(side);
      const Matrix2& clocks_root_px = point.clocks_root_px[side];
      covariance.block<2, 2>(row, row) +=
          point.pixels[side].covariance_px2 - clocks_root_px * clocks_root_px.transpose();
      if (!point.next) continue;
      const Eigen::Index next = row_of((i + 1) % part.size()) + first_row(side);
      covariance.block<2, 2>(row, next) += point.shared_with_next_px2[side];
      covariance.block<2, 2>(next, row) += point.shared_with_next_px2[side].transpose();
    }
  }
  return covariance;
}

Eigen::Matrix<double, kPixels, 3> pixels_by_place(const Rig& rig, const Vec3& place_in_rig_mm) {
  Eigen::Matrix<double, kPixels, 3> by_place;
  for (const Side side : kBothSides) {
    const Isometry3& camera_from_rig = rig.camera_from_rig[side];
    by_place.middleRows<2>(first_row(side)) =
        projection_jacobian_px_per_mm(rig.cameras[side], camera_from_rig * place_in_rig_mm) * camera_from_rig.linear();
  }
  return by_place;
}

std::optional<PixelOffset> pixel_offset(const Isometry3& rig_from_target, std::span<const LocatedPoint> part,
                                        const Rig& rig) {
  PixelOffset offset{PixelRows(row_of(part.size())), PixelRowsByPose(row_of(part.size()), 6)};
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec3 arm_mm = rig_from_target.linear() * part[i].of.in_target_mm;
    const Vec3 in_rig_mm = rig_from_target.translation() + arm_mm;
    for (const Side side : kBothSides) {
      const Result<RawPixel> predicted = projected(rig.cameras[side], rig.camera_from_rig[side] * in_rig_mm);
      if (!predicted) return std::nullopt;
      const RawPixel& seen = part[i].pixels[side].at;
      offset.px.segment<2>(row_of(i) + first_row(side)) << seen.u_px - predicted->u_px, seen.v_px - predicted->v_px;
    }
    const Eigen::Matrix<double, kPixels, 3> by_place = pixels_by_place(rig, in_rig_mm);
    offset.by_pose.middleRows<kPixels>(row_of(i)) << by_place, -by_place * cross_matrix(arm_mm);
  }
  return offset;
}

}  // namespace tripoint
