#include "tags/tag_tracker.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "drawn_tag.h"
#include "rendered_tags.h"
#include "tags/tag_points.h"

namespace tripoint {
namespace {

using test::kCodes36h11;
using test::Sheet;
using test::tag36h11;

TagTracker tracker_of_all() {
  Result<TagTracker> tracker = TagTracker::open({});
  EXPECT_TRUE(tracker) << tracker.error().message;
  return std::move(*tracker);
}

Picture numbered(Picture picture, std::uint32_t frame) {
  picture.frame = frame;
  return picture;
}

bool is_whole(const SeenTags& seen) { return seen.coverage == Coverage::kWholeFrame; }

std::size_t kept(const SeenTags& seen) {
  return static_cast<std::size_t>(std::count_if(
      seen.tags.begin(), seen.tags.end(), [](const SeenTag& tag) { return tag.outline.cause == TagCause::kKept; }));
}

/// A tag of 50 px with its middle at a place of the picture.
Matrix3 standing_at(const Vec2& middle_px) {
  return test::seen_by_camera(Matrix3::Identity(),
                              {(middle_px.x() - 320.0) * 400.0 / 628.0, (middle_px.y() - 240.0) * 400.0 / 628.0, 400.0},
                              50.0 * 400.0 / 628.0);
}

struct Print {
  std::size_t id;
  Vec2 middle_px;
};

/// Owns the picture that it shows.
Sheet sheet_of(const std::vector<Print>& prints, std::uint32_t seed = 1) {
  Sheet sheet({240, 120}, seed);
  for (const Print& print : prints) sheet.draw(tag36h11(kCodes36h11[print.id]), standing_at(print.middle_px));
  return sheet;
}

const std::vector<Print> kTwo{{0, {60.0, 60.0}}, {1, {160.0, 60.0}}};

double worst_px(const SeenTag& tag, const Matrix3& pixels_from_tag) {
  const auto truth = test::corners_of(pixels_from_tag);
  double worst = 0.0;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    worst = std::max(worst, (places_of(tag.outline.corners_px)[k] - truth[k]).norm());
  }
  return worst;
}

TEST(TagTrackerTest, EveryFifthPictureIsDecodedByItsNumber) {
  TagTracker tracker = tracker_of_all();
  Sheet sheet = sheet_of(kTwo);
  const Picture picture = sheet.grey();
  for (const std::uint32_t start : {7U, 0xFFFFFFF0U}) {  // the numbers wrap around
    for (std::uint32_t i = 0; i < 20; ++i) {
      const SeenTags& seen = tracker.see(numbered(picture, start + i));
      EXPECT_EQ(is_whole(seen), i % 5 == 0) << i;
      EXPECT_EQ(kept(seen), 2U);
    }
  }
  // Whole at 100; 103 and 104 are within four of it, 106 is not.
  for (const auto& [frame, whole] : {std::pair{100U, true}, {103U, false}, {104U, false}, {106U, true}}) {
    EXPECT_EQ(is_whole(tracker.see(numbered(picture, frame))), whole) << frame;
  }
}

TEST(TagTrackerTest, NothingIsForeseenOverManyDroppedFramesNorWithoutNumbers) {
  TagTracker tracker = tracker_of_all();
  Sheet sheet = sheet_of(kTwo);
  const Picture picture = sheet.grey();
  for (const std::uint32_t frame : {10U, 14U, 14U, 3U, 3U}) {  // four on; the same again; back
    EXPECT_TRUE(is_whole(tracker.see(numbered(picture, frame)))) << frame;
  }
  Sheet smaller({200, 120});
  smaller.draw(tag36h11(kCodes36h11[0]), standing_at({60.0, 60.0}));
  EXPECT_TRUE(is_whole(tracker.see(numbered(smaller.grey(), 4))));
}

TEST(TagTrackerTest, TagsAreFollowedOnTheirWay) {
  TagTracker tracker = tracker_of_all();
  int followed = 0;
  for (std::uint32_t frame = 0; frame < 11; ++frame) {
    const Vec2 step_px = frame * Vec2(7.3, 1.4);  // more than is looked at around a corner
    const std::vector<Print> prints{{0, Vec2(50.0, 50.0) + step_px}, {1, Vec2(130.0, 55.0) + step_px}};
    Sheet sheet = sheet_of(prints);
    const SeenTags& seen = tracker.see(numbered(sheet.grey(), frame));
    ASSERT_EQ(kept(seen), 2U) << frame;
    if (!is_whole(seen)) ++followed;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(seen.tags[i].decoded.id, static_cast<int>(prints[i].id));
      EXPECT_LT(worst_px(seen.tags[i], standing_at(prints[i].middle_px)), 0.05) << frame;
    }
  }
  EXPECT_EQ(followed, 8);  // not 0 and 1, which had no way yet; not 6
}

TEST(TagTrackerTest, AJumpIsDecodedAtOnce) {
  TagTracker tracker = tracker_of_all();
  Sheet before = sheet_of({{0, {60.0, 60.0}}});
  Sheet after = sheet_of({{0, {69.0, 60.0}}});
  tracker.see(numbered(before.grey(), 0));
  EXPECT_FALSE(is_whole(tracker.see(numbered(before.grey(), 1))));
  const SeenTags& seen = tracker.see(numbered(after.grey(), 2));
  EXPECT_TRUE(is_whole(seen));
  ASSERT_EQ(kept(seen), 1U);
  EXPECT_LT(worst_px(seen.tags[0], standing_at({69.0, 60.0})), 0.05);
}

TEST(TagTrackerTest, ATagThatIsCoveredIsGoneInThatPictureAndTheOthersStay) {
  TagTracker tracker = tracker_of_all();
  Sheet sheet = sheet_of(kTwo);
  tracker.see(numbered(sheet.grey(), 0));
  sheet.cover(150, 50, 190, 90);
  const SeenTags& seen = tracker.see(numbered(sheet.grey(), 1));
  EXPECT_TRUE(is_whole(seen));
  ASSERT_EQ(kept(seen), 1U);
  EXPECT_EQ(seen.tags[0].decoded.id, 0);
  EXPECT_FALSE(is_whole(tracker.see(numbered(sheet.grey(), 2))));  // the other goes on
}

TEST(TagTrackerTest, AnotherTagAtTheSamePlaceIsNotTakenForIt) {
  TagTracker tracker = tracker_of_all();
  Sheet before = sheet_of({{0, {60.0, 60.0}}});
  Sheet after = sheet_of({{2, {60.0, 60.0}}});
  tracker.see(numbered(before.grey(), 0));
  const SeenTags& seen = tracker.see(numbered(after.grey(), 1));
  ASSERT_EQ(seen.tags.size(), 1U);
  EXPECT_EQ(seen.tags[0].decoded.id, 2);
  EXPECT_TRUE(is_whole(seen));
}

TEST(TagTrackerTest, ATagWhoseBitsAreCoveredIsNotFollowed) {
  TagTracker tracker = tracker_of_all();
  Sheet sheet = sheet_of({{0, {60.0, 60.0}}});
  tracker.see(numbered(sheet.grey(), 0));
  sheet.cover(54, 54, 67, 67);  // four cells, 15 px from the edges
  EXPECT_TRUE(is_whole(tracker.see(numbered(sheet.grey(), 1))));
}

TEST(TagTrackerTest, ANewTagIsSeenWithinFourPictures) {
  TagTracker tracker = tracker_of_all();
  Sheet one = sheet_of({kTwo[0]});
  Sheet two = sheet_of(kTwo);
  tracker.see(numbered(one.grey(), 0));
  const Picture picture = two.grey();
  for (std::uint32_t frame = 1; frame <= 5; ++frame) {
    EXPECT_EQ(kept(tracker.see(numbered(picture, frame))), frame < 5 ? 1U : 2U);
  }
}

TEST(TagTrackerTest, AsLongAsATagIsThereTwiceOrCannotBeMeasuredEveryPictureIsDecoded) {
  Sheet twice = sheet_of({{0, {60.0, 60.0}}, {0, {160.0, 60.0}}});
  Sheet cut = sheet_of({{0, {60.0, 60.0}}, {1, {212.5, 60.0}}});  // 2 px of light beside its edge
  Sheet none = sheet_of({});
  for (Sheet* const sheet : {&twice, &cut, &none}) {
    TagTracker tracker = tracker_of_all();
    for (std::uint32_t frame = 0; frame < 4; ++frame) {
      EXPECT_TRUE(is_whole(tracker.see(numbered(sheet->grey(), frame)))) << frame;
    }
  }
}

// As decoded ones: no cover along an edge moves a corner, whenever it comes.
TEST(TagTrackerTest, ACoverAlongAnEdgeNeverMovesACornerOfAFollowedTag) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int followed = 0;
  for (int view = 0; view < 120; ++view) {
    TagTracker tracker = tracker_of_all();
    const Matrix3 turned = Eigen::AngleAxisd(6.28 * unit(random), Vec3::UnitZ()).toRotationMatrix();
    Matrix3 moved = Matrix3::Identity();
    moved.topRightCorner<2, 1>() << 70.0 - 320.0, 70.0 - 240.0;
    const Matrix3 pixels_from_tag =
        moved * test::seen_by_camera(turned, {0.0, 0.0, 400.0}, (30.0 + 30.0 * unit(random)) * 400.0 / 628.0);
    Sheet sheet({140, 140}, static_cast<std::uint32_t>(view));
    sheet.draw(tag36h11(kCodes36h11[0]), pixels_from_tag);
    tracker.see(numbered(sheet.grey(), 0));
    const auto corners = test::corners_of(pixels_from_tag);
    const std::size_t edge = random() % kTagCorners;
    const double begin_px = -4.0 + 8.0 * unit(random);
    sheet.lay_strip(corners[edge], corners[(edge + 1) % kTagCorners], begin_px,
                    begin_px + (view % 2 == 0 ? 50.0 : 1.0 + 7.0 * unit(random)), 255.0 * unit(random));
    sheet.add_noise(3.0 * unit(random));
    const SeenTags& seen = tracker.see(numbered(sheet.grey(), 1));
    if (is_whole(seen)) continue;
    ++followed;
    EXPECT_LT(worst_px(seen.tags[0], pixels_from_tag), 0.4) << view;
  }
  EXPECT_GT(followed, 10);
  EXPECT_LT(followed, 100);
}

/// Three rendered tags on the paper's way, as one camera sees them.
struct RenderedWay {
  explicit RenderedWay(PixelFormat format) {
    SimulationSettings settings = test::tagged_settings();
    settings.format = format;
    settings.rig = default_rig();
    for (const Side side : kBothSides) settings.rig.cameras[side].distortion = {};  // edges are straight
    world = std::make_unique<SimulatedWorld>(*SimulatedWorld::create(settings));
    renderer = std::make_unique<FrameRenderer>(*world, Side::kLeft);
  }
  const RenderedFrame& frame(std::uint32_t number) {
    return renderer->render(duration_from_seconds(2.0 + number / 30.0), number);
  }
  std::unique_ptr<SimulatedWorld> world;
  std::unique_ptr<FrameRenderer> renderer;
};

/// Of all formats that are read in place.
class FollowedTagsTest : public testing::TestWithParam<PixelFormat> {};

TEST_P(FollowedTagsTest, CornersAreWhereTheyTrulyAreAndErrAsStated) {
  RenderedWay way(GetParam());
  TagTracker tracker = tracker_of_all();
  double squares_px2 = 0.0;
  double normalised = 0.0;
  int tags = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    const RenderedFrame& rendered = way.frame(number);
    const SeenTags& seen = tracker.see(numbered(picture_of(frame_of(rendered)), number));
    ASSERT_EQ(kept(seen), 3U) << number;
    EXPECT_EQ(is_whole(seen), number % 5 == 0) << number;
    if (is_whole(seen)) continue;
    for (const SeenTag& tag : seen.tags) {
      const auto truth = places_of(rendered.truth.tags[static_cast<std::size_t>(tag.decoded.id)].corners_px);
      Eigen::Matrix<double, 2 * kTagCorners, 1> errors;
      for (std::size_t k = 0; k < kTagCorners; ++k) {
        errors.segment<2>(static_cast<Eigen::Index>(2 * k)) = places_of(tag.outline.corners_px)[k] - truth[k];
      }
      squares_px2 += errors.squaredNorm() / (2.0 * kTagCorners);
      const CornerCovariance stated = tag.outline.covariance_px2 + 0.05 * 0.05 * CornerCovariance::Identity();
      normalised += errors.dot(stated.ldlt().solve(errors));
      EXPECT_GE(tag.decoded.margin, 25.0);
      ++tags;
    }
  }
  EXPECT_EQ(tags, 96);
  EXPECT_LT(std::sqrt(squares_px2 / tags), 0.02);  // the product's figure
  EXPECT_LT(normalised / tags, 8.0);               // chi-square of eight, with the camera's share stated on top
}

INSTANTIATE_TEST_SUITE_P(All, FollowedTagsTest, testing::Values(PixelFormat::kGrey, PixelFormat::kYuyv));

TEST(TagTrackerTest, TheSamePicturesAgainShowTheSameToTheBit) {
  RenderedWay way(PixelFormat::kGrey);
  TagTracker one = tracker_of_all();
  TagTracker other = tracker_of_all();
  for (std::uint32_t number = 0; number < 7; ++number) {
    const RenderedFrame& rendered = way.frame(number);
    const Picture picture = numbered(picture_of(frame_of(rendered)), number);
    const SeenTags& first = one.see(picture);
    const SeenTags& second = other.see(picture);
    ASSERT_EQ(first.tags.size(), second.tags.size());
    for (std::size_t i = 0; i < first.tags.size(); ++i) {
      EXPECT_EQ(places_of(first.tags[i].outline.corners_px), places_of(second.tags[i].outline.corners_px));
      EXPECT_EQ(first.tags[i].outline.covariance_px2, second.tags[i].outline.covariance_px2);
    }
  }
}

}  // namespace
}  // namespace tripoint
