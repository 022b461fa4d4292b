// Following tags allocates nothing; libapriltag does.
#include <gtest/gtest.h>

#include "counted_allocations.h"
#include "drawn_tag.h"
#include "tags/tag_points.h"
#include "tags/tag_tracker.h"

namespace tripoint {
namespace {

TEST(TagAllocationTest, APictureBetweenDecodesCostsNone) {
  if (!testing::allocations_are_counted()) GTEST_SKIP() << "a sanitizer stands in for malloc: nothing can be counted";
  test::Sheet sheet;
  sheet.draw(test::tag36h11(test::kCodes36h11[0]), test::seen_by_camera(Matrix3::Identity(), {0.0, 0.0, 400.0}, 50.0));
  Picture picture = sheet.grey();
  TagTracker tracker = *TagTracker::open({});
  const std::array<int, 1> ids{0};
  std::size_t points = 0;
  EXPECT_GT(testing::allocations_in([&] { tracker.see(picture); }), 0);
  for (picture.frame = 1; picture.frame < 5; ++picture.frame) {
    EXPECT_EQ(testing::allocations_in([&] { points += points_of(tracker.see(picture), ids).points.size(); }), 0);
  }
  EXPECT_EQ(points, 4 * kTagCorners);
}

}  // namespace
}  // namespace tripoint
