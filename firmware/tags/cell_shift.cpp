#include "tags/cell_shift.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "line/model.h"

namespace tripoint {
namespace {

using Vec4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

constexpr double kReach_cells = 0.45;
constexpr double kMostReach_px = 2.5;  // as for edges: noise far from the step moves its centroid
constexpr std::size_t kSamples = 9;
constexpr double kLeastRise = 0.3;  // of the contrast; blur takes more of it only where cells are below 1.5 px
constexpr double kLeastSeen = 6.0;  // sides of cells, along x and along y
constexpr double kShareSeen = 0.8;
constexpr double kMostShift_px = 0.1;
constexpr double kMostOfBloom = 0.1;  // light does not bloom alike beside everything
constexpr double kMostDeviations = 3.0;

enum class Axis : std::uint8_t { kX, kY };

/// How far one side of a cell lies from its place, along x or y of the tag.
std::optional<double> shift_of(const LumaView& luma, const CellSide& side, const TagPlane& plane, double cell,
                               double least_rise) {
  const TagPlane::Place place = plane.at(side.at);
  const Vec2 px_by_shift = place.px_by_place.col(side.between_x ? 0 : 1);
  const double reach = std::min(kReach_cells * cell, kMostReach_px / px_by_shift.norm());
  const std::optional<LumaProfile> profile =
      luma.along(place.at_px - reach * px_by_shift, place.at_px + reach * px_by_shift, kSamples);
  if (!profile) return std::nullopt;
  const auto rise = static_cast<double>(profile->back() - (*profile)[0]);
  if ((side.light_after ? rise : -rise) < least_rise) return std::nullopt;
  constexpr double kHalf = 0.5 * static_cast<double>(kSamples);
  double moment = 0.0;
  for (std::size_t i = 1; i < kSamples; ++i) {
    moment += static_cast<double>((*profile)[i] - (*profile)[i - 1]) * (static_cast<double>(i) - kHalf);
  }
  const double shift = 2.0 * reach / static_cast<double>(kSamples - 1) * moment / rise;
  return std::abs(shift) <= reach ? std::optional(shift) : std::nullopt;
}

/// What moves a place where light meets dark, along one axis of the tag: a x + b y + c, and what makes light wider.
Vec4 causes_at(const Vec2& at, bool light_after) { return {at.x(), at.y(), 1.0, light_after ? -1.0 : 1.0}; }

/// The shifts along one axis, by least squares.
class ShiftFit {
 public:
  void add(const CellSide& side, double shift) {
    const Vec4 row = causes_at(side.at, side.light_after);
    normal_ += row * row.transpose();
    right_ += shift * row;
    squares_ += shift * shift;
    count_ += 1.0;
  }
  [[nodiscard]] double count() const { return count_; }
  /// Once all are added; more than there are causes.
  void solve() {
    inverse_ = normal_.inverse();
    weights_ = inverse_ * right_;
    variance_ = std::max(0.0, squares_ - weights_.dot(right_)) / (count_ - 4.0);
  }
  /// By how much light is wider.
  [[nodiscard]] double bloom() const { return std::abs(weights_[3]); }
  [[nodiscard]] double at(const Vec4& causes) const { return weights_.dot(causes); }
  [[nodiscard]] double deviation_at(const Vec4& causes) const {
    return std::sqrt(variance_ * causes.dot(inverse_ * causes));
  }

 private:
  Matrix4 normal_ = Matrix4::Zero();
  Matrix4 inverse_ = Matrix4::Zero();
  Vec4 right_ = Vec4::Zero();
  Vec4 weights_ = Vec4::Zero();
  double squares_ = 0.0;
  double count_ = 0.0;
  double variance_ = 0.0;
};

bool corners_stay(const ShiftFit& fit, Axis axis, const TagPattern& pattern, const TagPlane& plane) {
  return std::all_of(kTagCornerPlaces.begin(), kTagCornerPlaces.end(), [&](const std::array<double, 2>& corner) {
    const Vec2 place(corner[0], corner[1]);
    const std::size_t along = axis == Axis::kX ? 0 : 1;
    const double px_by_shift = plane.at(place).px_by_place.col(static_cast<Eigen::Index>(along)).norm();
    const bool last = corner[along] > 0.0;
    const Vec4 causes = causes_at(place, last != pattern.light_inside);
    return px_by_shift * std::abs(fit.at(causes)) <=
           kMostShift_px + px_by_shift * (kMostOfBloom * fit.bloom() + kMostDeviations * fit.deviation_at(causes));
  });
}

}  // namespace

bool cells_agree(const LumaView& luma, const TagPattern& pattern, const TagPlane& plane, double contrast) {
  ShiftFit along_x;
  ShiftFit along_y;
  for (const CellSide& side : pattern.sides) {
    const std::optional<double> shift = shift_of(luma, side, plane, pattern.cell(), kLeastRise * contrast);
    if (shift) (side.between_x ? along_x : along_y).add(side, *shift);
  }
  const double seen = along_x.count() + along_y.count();
  if (std::min(along_x.count(), along_y.count()) < kLeastSeen ||
      seen < kShareSeen * static_cast<double>(pattern.sides.size())) {
    return false;
  }
  along_x.solve();
  along_y.solve();
  return corners_stay(along_x, Axis::kX, pattern, plane) && corners_stay(along_y, Axis::kY, pattern, plane);
}

}  // namespace tripoint
