#include "line/align/association.h"

#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr double kGate_px = 100.0;

TEST(AssociationTest, ASinglePointIsFollowedWithinTheGateOnly) {
  const std::vector<Vec2> before{{100.0, 100.0}};
  const std::vector<Vec2> near{{199.0, 100.0}};
  const std::vector<Vec2> far{{201.0, 100.0}};
  EXPECT_EQ(linked(before, near, kGate_px)[0].before, 0U);
  EXPECT_FALSE(linked(before, far, kGate_px)[0].before);
  EXPECT_FALSE(linked(before, far, kGate_px)[0].ambiguous);
}

TEST(AssociationTest, PointsMayChangeTheirOrder) {
  const std::vector<Vec2> before{{100.0, 100.0}, {300.0, 100.0}, {200.0, 300.0}};
  const std::vector<Vec2> now{{205.0, 303.0}, {105.0, 103.0}, {305.0, 103.0}};
  const auto links = linked(before, now, kGate_px);
  EXPECT_EQ(links[0].before, 2U);
  EXPECT_EQ(links[1].before, 0U);
  EXPECT_EQ(links[2].before, 1U);
}

TEST(AssociationTest, TwoPointsAboutAsNearAreAmbiguous) {
  const std::vector<Vec2> before{{100.0, 100.0}, {120.0, 100.0}};
  const std::vector<Vec2> now{{111.0, 100.0}};
  EXPECT_TRUE(linked(before, now, kGate_px)[0].ambiguous);
  EXPECT_FALSE(linked(before, now, kGate_px)[0].before);
}

TEST(AssociationTest, TwoPointsThatCouldBothBeTheSameAreAmbiguous) {
  const std::vector<Vec2> before{{100.0, 100.0}};
  const std::vector<Vec2> now{{108.0, 100.0}, {91.0, 100.0}};
  for (const Link& link : linked(before, now, kGate_px)) EXPECT_TRUE(link.ambiguous || !link.before);
}

TEST(AssociationTest, ARunnerUpTwiceAsFarIsNone) {
  const std::vector<Vec2> before{{100.0, 100.0}, {140.0, 100.0}};
  const std::vector<Vec2> now{{110.0, 100.0}};  // 10 px against 30
  EXPECT_EQ(linked(before, now, kGate_px)[0].before, 0U);
}

TEST(AssociationTest, NothingBeforeMeansNewPoints) {
  const std::vector<Vec2> now{{110.0, 100.0}};
  const auto links = linked({}, now, kGate_px);
  ASSERT_EQ(links.size(), 1U);
  EXPECT_FALSE(links[0].before);
  EXPECT_FALSE(links[0].ambiguous);
}

}  // namespace
}  // namespace tripoint
