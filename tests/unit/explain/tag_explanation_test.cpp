#include "explain/tag_explanation.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "bench/painter.h"
#include "explain/look.h"
#include "explain/sheet.h"

namespace tripoint {
namespace {

constexpr double kMinMargin = 25.0;
constexpr int kPictureTop_px = 100;  // below the heading, roughly: where its height does not matter

/// A square of 40 px with its lower left corner at (100, 140), or elsewhere.
SeenTag tag_with(TagCause cause, double left_px = 100.0, double top_px = 100.0) {
  SeenTag tag;
  tag.decoded.id = 7;
  tag.decoded.margin = 12.34;
  tag.outline.cause = cause;
  tag.outline.corners_px = {RawPixel{left_px, top_px + 40.0}, RawPixel{left_px + 40.0, top_px + 40.0},
                            RawPixel{left_px + 40.0, top_px}, RawPixel{left_px, top_px}};
  tag.outline.covariance_px2 = 4e-4 * CornerCovariance::Identity();
  return tag;
}

RgbImage explained(const std::vector<SeenTag>& tags, bool cut = false) {
  std::mt19937 random(3);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same noise each time
  const auto developed = bench::Painting({640, 480}, 0.3).develop({}, random);
  SeenTags seen;
  seen.cut = cut;
  for (const SeenTag& tag : tags) seen.tags.push_back(tag);
  return explanation_of(developed.view(), seen, kMinMargin, "painted");
}

long pixels_of(const RgbImage& image, Colour colour) {
  long count = 0;
  for (int y = kPictureTop_px; y < image.size.height_px; ++y) {
    for (int x = 0; x < image.size.width_px; ++x) count += image.at(x, y) == colour ? 1 : 0;
  }
  return count;
}

// Twice as large as the picture: four edges of 80 px in the overview, four of 80 px or more in the close-up; marks of
// the corners hide some of each.
TEST(TagExplanationTest, AMeasuredTagIsOutlinedAndShownCloseUp) {
  const RgbImage none = explained({});
  const RgbImage one = explained({tag_with(TagCause::kKept)});
  EXPECT_GE(one.size.height_px, none.size.height_px + kCloseUpSize.height_px);
  EXPECT_GT(pixels_of(one, kKeptColour), pixels_of(none, kKeptColour) + 4 * 60 + 4 * 80);
  EXPECT_EQ(pixels_of(one, kDroppedColour), pixels_of(none, kDroppedColour));
}

TEST(TagExplanationTest, OneThatTakesNoPartInAPoseHasTheOtherColour) {
  const RgbImage none = explained({});
  const RgbImage one = explained({tag_with(TagCause::kCrookedEdge)});
  EXPECT_GT(pixels_of(one, kDroppedColour), pixels_of(none, kDroppedColour) + 4 * 60 + 4 * 80);
  EXPECT_EQ(pixels_of(one, kKeptColour), pixels_of(none, kKeptColour));
}

TEST(TagExplanationTest, EveryCauseIsSaidAndNumbersAreMeasured) {
  for (std::size_t cause = 0; cause < kTagCauseNames.size(); ++cause) {
    EXPECT_FALSE(why(tag_with(static_cast<TagCause>(cause)), kMinMargin).empty()) << kTagCauseNames[cause];
  }
  EXPECT_EQ(why(tag_with(TagCause::kUnsureBits), kMinMargin), "margin 12.3 < 25.0");
  EXPECT_EQ(why(tag_with(TagCause::kTooSmall), kMinMargin), "edge of 40 px");
  EXPECT_EQ(why(tag_with(TagCause::kKept), kMinMargin), "corners' sd up to 0.020 px");
}

TEST(TagExplanationTest, TagsAtTheBorderOrAsLargeAsThePictureAreShownToo) {
  SeenTag large = tag_with(TagCause::kKept);
  large.outline.corners_px = {RawPixel{0.0, 479.0}, RawPixel{639.0, 479.0}, RawPixel{639.0, 0.0}, RawPixel{0.0, 0.0}};
  SeenTag point = tag_with(TagCause::kTooSmall);
  point.outline.corners_px.fill({320.0, 240.0});
  const RgbImage image = explained(
      {large, point, tag_with(TagCause::kCutByBorder, -20.0, -20.0), tag_with(TagCause::kKept, 620.0, 460.0)});
  EXPECT_GT(pixels_of(image, kOutside), 0);
}

TEST(TagExplanationTest, ManyTagsAreShownUpToALimitAndTheRestCounted) {
  std::vector<SeenTag> tags;
  for (std::size_t i = 0; i < kMaxDecodedTags; ++i) {
    tags.push_back(tag_with(TagCause::kKept, 75.0 * static_cast<double>(i % 8), 55.0 * static_cast<double>(i / 8)));
  }
  const RgbImage few = explained({tags.begin(), tags.begin() + 24}, true);
  EXPECT_LT(explained(tags, true).size.height_px, few.size.height_px + 60);  // no further row of close-ups
}

}  // namespace
}  // namespace tripoint
