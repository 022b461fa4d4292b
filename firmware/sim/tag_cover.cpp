#include "sim/tag_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tripoint {
namespace {

constexpr double kReachSigmas = 4.0;  // beyond it an edge covers less than 4e-5
constexpr double kEdgeOn_mm = 1e-3;   // of the camera from the plane of the tag

/// How much of a blurred pixel lies on each cell, along one axis of the tag.
struct AxisShares {
  int first = 0;
  int count = 0;  ///< 0: the print is out of reach
  std::array<double, kMostTagCells> shares{};
  double sum = 0.0;
};

AxisShares shares_along(double place, double sigma, int cells, const NormalIntegral& normal) {
  AxisShares axis;
  const double reach = kReachSigmas * sigma;
  if (!(place > -reach && place < cells + reach)) return axis;
  axis.first = static_cast<int>(std::clamp(std::floor(place - reach), 0.0, cells - 1.0));
  const int last = static_cast<int>(std::clamp(std::floor(place + reach), 0.0, cells - 1.0));
  axis.count = last - axis.first + 1;
  const auto share_up_to = [&](int edge) {
    return static_cast<double>(normal(static_cast<float>((edge - place) / sigma)));
  };
  double before = share_up_to(axis.first);
  for (int i = 0; i < axis.count; ++i) {
    const double after = share_up_to(axis.first + i + 1);
    axis.shares[static_cast<std::size_t>(i)] = after - before;
    axis.sum += after - before;
    before = after;
  }
  return axis;
}

double light_of_cells(const AxisShares& across, const AxisShares& down, const PrintedTag& tag) {
  double light = 0.0;
  for (int row = 0; row < down.count; ++row) {
    double of_row = 0.0;
    for (int column = 0; column < across.count; ++column) {
      const bool is_light = tag.cells.is_light(across.first + column, down.first + row);
      of_row +=
          across.shares[static_cast<std::size_t>(column)] * (is_light ? tag.light_reflectance : tag.dark_reflectance);
    }
    light += down.shares[static_cast<std::size_t>(row)] * of_row;
  }
  return light;
}

}  // namespace

std::optional<TagSight> sight_of(const PrintedTag& tag, const Isometry3& camera_from_tag) {
  const double camera_behind_mm = camera_from_tag.inverse().translation().z();
  if (std::abs(camera_behind_mm) < kEdgeOn_mm) return std::nullopt;
  const double cells_per_mm = tag.cells.across / tag.size_mm;
  const double middle = 0.5 * tag.cells.total;
  Matrix3 cells_from_tag;
  cells_from_tag << cells_per_mm, 0.0, middle, 0.0, cells_per_mm, middle, 0.0, 0.0, 1.0;
  Matrix3 camera_from_plane;
  camera_from_plane << camera_from_tag.linear().leftCols<2>(), camera_from_tag.translation();
  return TagSight{.cells_from_direction = cells_from_tag * camera_from_plane.inverse(),
                  .front = camera_behind_mm < 0.0};
}

TagCover cover_at(const PixelRay& ray, const PrintedTag& tag, const TagSight& sight, double blur_px,
                  const NormalIntegral& normal) {
  const Matrix3& cells_from_direction = sight.cells_from_direction;
  const Vec3 seen = cells_from_direction * Vec3(ray.direction.x, ray.direction.y, 1.0);
  if (seen.z() <= 0.0) return {};  // this pixel looks away from the plane
  const Vec2 place = seen.hnormalized();
  const Matrix2 cells_per_direction =
      (cells_from_direction.topLeftCorner<2, 2>() - place * cells_from_direction.row(2).head<2>()) / seen.z();
  const Vec2 sigma = blur_px * (cells_per_direction * ray.per_px).rowwise().norm();
  const AxisShares across = shares_along(place.x(), sigma.x(), tag.cells.total, normal);
  if (across.count == 0) return {};
  const AxisShares down = shares_along(place.y(), sigma.y(), tag.cells.total, normal);
  const double share = across.sum * down.sum;
  return {.share = share, .light = sight.front ? light_of_cells(across, down, tag) : share * tag.back_reflectance};
}

}  // namespace tripoint
