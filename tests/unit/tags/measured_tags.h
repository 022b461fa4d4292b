// What a detector makes of drawn tags, and how far it is off.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drawn_tag.h"
#include "tags/tag_detector.h"

namespace tripoint::test {

using Errors = Eigen::Matrix<double, 2 * kTagCorners, 1>;

inline TagDetector detector_for(const std::string& family = "tag36h11") {
  Result<TagDetector> detector = TagDetector::open({.family = family});
  EXPECT_TRUE(detector) << detector.error().message;
  return std::move(*detector);
}

inline std::vector<SeenTag> kept_in(const Picture& picture, TagDetector& detector) {
  std::vector<SeenTag> kept;
  for (const SeenTag& tag : detector.detect(picture).tags) {
    if (tag.outline.cause == TagCause::kKept) kept.push_back(tag);
  }
  return kept;
}

/// Upright in the middle of the picture, 80 px wide.
inline Matrix3 upright() { return seen_by_camera(Matrix3::Identity(), {1.0, 2.0, 400.0}, 50.96); }

inline Errors errors_px(const TagOutline& outline, const Matrix3& pixels_from_tag) {
  const auto truth = corners_of(pixels_from_tag);
  Errors errors;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const RawPixel& seen = outline.corners_px[k];
    errors.segment<2>(static_cast<Eigen::Index>(2 * k)) = Vec2(seen.u_px, seen.v_px) - truth[k];
  }
  return errors;
}

}  // namespace tripoint::test
