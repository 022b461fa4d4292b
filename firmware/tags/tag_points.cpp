#include "tags/tag_points.h"

#include <algorithm>

namespace tripoint {
namespace {

// What a camera does to an edge and the scatter along it does not show: tone curve, sharpening, mosaic, compression.
constexpr double kCamera_px = 0.05;
constexpr double kClipped = 254.0;  // mean luma; noise takes some of it below 255

Matrix2 covariance_of(const TagOutline& outline, std::size_t corner, std::size_t other) {
  return outline.covariance_px2.block<2, 2>(static_cast<Eigen::Index>(2 * corner),
                                            static_cast<Eigen::Index>(2 * other));
}

ImagePoint point_of(const SeenTag& tag, std::size_t corner) {
  ImagePoint point;
  point.at = tag.outline.corners_px[corner];
  point.covariance_px2 = covariance_of(tag.outline, corner, corner) + kCamera_px * kCamera_px * Matrix2::Identity();
  point.label = PointLabel{tag.decoded.id, static_cast<int>(corner)};
  point.shared_with_next_px2 = covariance_of(tag.outline, corner, (corner + 1) % kTagCorners);
  point.amplitude = tag.outline.light - tag.outline.dark;
  point.peak = tag.outline.lightest;
  point.saturated = clips(tag.outline);
  return point;
}

/// Another print of the same tag, measured or not, makes it unknown which of them is the target's.
bool is_alone(const SeenTag& tag, const SeenTags& seen) {
  return std::count_if(seen.tags.begin(), seen.tags.end(),
                       [&](const SeenTag& other) { return other.decoded.id == tag.decoded.id; }) == 1;
}

}  // namespace

bool clips(const TagOutline& outline) { return outline.lightest >= kClipped; }

TagPoints points_of(const SeenTags& seen, std::span<const int> wanted_ids) {
  TagPoints found;
  found.health.mean_luma = seen.mean_luma;
  found.health.candidates_cut = seen.cut;
  for (const SeenTag& tag : seen.tags) {
    const bool measured = tag.outline.cause == TagCause::kKept;
    if (!measured && is_alone(tag, seen)) continue;
    if (std::find(wanted_ids.begin(), wanted_ids.end(), tag.decoded.id) == wanted_ids.end()) continue;
    if (found.points.size() + kTagCorners > kMaxImagePoints) {
      found.health.candidates_cut = true;
      continue;
    }
    if (measured) {
      const double light = tag.outline.light;
      found.health.peak_luma = std::max(found.health.peak_luma, tag.outline.lightest);
      found.health.dimmest_luma = found.health.dimmest_luma == 0.0 ? light : std::min(found.health.dimmest_luma, light);
    }
    for (std::size_t corner = 0; corner < kTagCorners; ++corner) found.points.push_back(point_of(tag, corner));
  }
  return found;
}

}  // namespace tripoint
