// Any bytes as a small grey picture in which libapriltag looks for tags: width, height, then the rows, black where the
// bytes end. The outline of whatever is decoded is measured, however unsure its bits; what is kept is whole.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "tags/tag_detector.h"
#include "tags/tag_points.h"

namespace {

constexpr std::size_t kHeader_bytes = 2;  // sides of 0 to 255 px

void check(bool condition) {
  if (!condition) std::abort();
}

/// tag36h11 as most use it; of tag16h5 chance makes many more. No margin: unsure ones are measured too.
std::array<tripoint::TagDetector, 2>& detectors() {
  static std::array<tripoint::TagDetector, 2> both{
      *tripoint::TagDetector::open({.family = "tag36h11", .min_margin = 0.0}),
      *tripoint::TagDetector::open({.family = "tag16h5", .min_margin = 0.0})};
  return both;
}

void check(const tripoint::SeenTag& tag, int ids) {
  check(tag.decoded.id >= 0 && tag.decoded.id < ids);
  for (const tripoint::RawPixel& corner : tag.outline.corners_px) check(std::isfinite(corner.u_px + corner.v_px));
  check(tag.outline.covariance_px2.allFinite());
  for (Eigen::Index i = 0; i < tag.outline.covariance_px2.rows(); ++i) check(tag.outline.covariance_px2(i, i) >= 0.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < kHeader_bytes) return 0;
  tripoint::Picture picture;
  picture.size = {data[0], data[1]};
  if (data[0] == 0 || data[1] == 0) return 0;
  std::vector<std::uint8_t> rows(data + kHeader_bytes, data + size);
  rows.resize(static_cast<std::size_t>(picture.size.width_px * picture.size.height_px));
  picture.luma = {rows.data(), static_cast<std::size_t>(picture.size.width_px), 1};
  const std::array<int, 3> ids{0, 1, 2};
  for (tripoint::TagDetector& detector : detectors()) {
    const tripoint::SeenTags seen = detector.detect(picture);
    for (const tripoint::SeenTag& tag : seen.tags) check(tag, detector.ids());
    check(tripoint::points_of(seen, ids).points.size() % tripoint::kTagCorners == 0);
  }
  return 0;
}
