// From two pictures of tags to a pose: detector and line together, against the drawn truth.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "drawn_tag.h"
#include "line/line.h"
#include "tags/tag_points.h"

namespace tripoint {
namespace {

constexpr double kSize_mm = 32.0;
const std::array<Vec3, 3> kPlaces_mm{Vec3(-45.0, -20.0, 0.0), Vec3(45.0, -12.0, 0.0), Vec3(0.0, 40.0, 0.0)};

/// The camera of drawn_tag.h twice, 100 mm apart and toed in by 5 degrees each.
LineModel drawn_model() {
  LineModel model;
  for (const Side side : kBothSides) model.calibration.cameras[side] = {{640, 480}, {628.0, 628.0}, {320.0, 240.0}, {}};
  model.calibration.right_from_left =
      Eigen::Translation3d(-99.6, 0.0, 8.7) * Eigen::AngleAxisd(10.0 * M_PI / 180.0, Vec3::UnitY());
  model.rig = *rig_of(model.calibration);
  model.limits.offset_prior_s = 1e-4;
  for (std::size_t i = 0; i < kPlaces_mm.size(); ++i) {
    TargetTag tag;
    tag.id = static_cast<int>(i);
    tag.uncertainty_mm = 0.0;
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      tag.corners_mm[k] = kPlaces_mm[i] + kSize_mm / 2.0 * Vec3(kTagCornerPlaces[k][0], kTagCornerPlaces[k][1], 0.0);
    }
    model.target.points.push_back({tag.id, kPlaces_mm[i], 0.0, std::nullopt});
    model.target.tags.push_back(tag);
  }
  return model;
}

Isometry3 rig_from_target() {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(0.35, Vec3(0.8, -0.6, 0.0)) * Eigen::AngleAxisd(-0.4, Vec3::UnitZ())).toRotationMatrix();
  pose.translation() = Vec3(12.0, 8.0, 405.0);
  return pose;
}

test::Sheet sheet_of(const LineModel& model, Side side) {
  test::Sheet sheet({640, 480}, side == Side::kLeft ? 1 : 2);
  const Isometry3 camera_from_target = model.rig.camera_from_rig[side] * rig_from_target();
  for (std::size_t i = 0; i < kPlaces_mm.size(); ++i) {
    sheet.draw(test::tag36h11(test::kCodes36h11[i]),
               test::seen_by_camera(camera_from_target.linear(), camera_from_target * kPlaces_mm[i], kSize_mm));
  }
  return sheet;
}

std::optional<Measurement> last_verdict(Line& line, PerSide<test::Sheet> clean) {
  TagDetector detector = *TagDetector::open({});
  const std::array<int, 3> ids{0, 1, 2};
  std::optional<Measurement> last;
  for (std::uint32_t frame = 0; frame < 3; ++frame) {
    for (const Side side : kBothSides) {
      test::Sheet sheet = clean[side];
      sheet.add_noise(2.0, 10 * frame + (side == Side::kLeft ? 1U : 2U));
      Observation seen;
      seen.side = side;
      seen.frame = frame;
      seen.exposed = TimePoint{duration_from_seconds(1.0 + frame / 30.0)};
      seen.arrived = seen.exposed + duration_from_seconds(0.01);
      const TagPoints found = points_of(detector.detect(sheet.grey()), ids);
      seen.points = found.points;
      seen.health = found.health;
      if (const auto verdict = line.step(seen)) last = verdict;
    }
  }
  return last;
}

TEST(TagLineTest, TwoPicturesOfThreeTagsGiveTheDrawnPose) {
  const LineModel model = drawn_model();
  Line line(std::make_shared<const LineModel>(model));
  const std::optional<Measurement> verdict =
      last_verdict(line, {sheet_of(model, Side::kLeft), sheet_of(model, Side::kRight)});
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->faults.bits(), 0);
  ASSERT_TRUE(verdict->pose && verdict->pose->output_from_target);
  const Eigen::AngleAxisd turn(*verdict->pose->output_from_target * rig_from_target().linear().transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << verdict->pose->position_in_output_mm - rig_from_target().translation(), turn.angle() * turn.axis();
  EXPECT_LT(error.head<3>().norm(), 0.1);   // 0.01 px at 405 mm is 0.05 mm in depth
  EXPECT_LT(error.tail<3>().norm(), 1e-3);  // over the 90 mm of the target
  // chi-square of 6 above 30 has a chance of 4e-5
  EXPECT_LT(error.dot(verdict->pose->noise.ldlt().solve(error)), 30.0);
  EXPECT_EQ(verdict->points.size(), 3U);
}

TEST(TagLineTest, APrintThatCannotBeMeasuredStillStandsBesideTheOtherOfItsId) {
  const std::array<int, 1> ids{7};
  SeenTag measured;
  measured.decoded.id = 7;
  SeenTag blurred = measured;
  blurred.outline.cause = TagCause::kBlurred;
  SeenTags seen;
  seen.tags.push_back(blurred);
  EXPECT_EQ(points_of(seen, ids).points.size(), 0U);
  seen.tags.push_back(measured);
  EXPECT_EQ(points_of(seen, ids).points.size(), 2 * kTagCorners);
}

// One edge that clips moves two corners, however dim the other three are.
TEST(TagLineTest, ATagWithOneEdgeThatClipsIsSaturated) {
  test::Sheet sheet({640, 480});
  const Matrix3 upright = test::seen_by_camera(Matrix3::Identity(), {0.0, 0.0, 400.0}, 50.0);
  sheet.draw(test::tag36h11(test::kCodes36h11[1]), upright);
  const Picture clean = sheet.grey();
  const auto corners = test::corners_of(upright);
  std::vector<std::uint8_t> lit(clean.luma.data, clean.luma.data + 640 * 480);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      std::uint8_t& luma = lit[static_cast<std::size_t>(640 * y + x)];
      const double along = (x - corners[0].x()) / (corners[1].x() - corners[0].x());
      luma = static_cast<std::uint8_t>(std::clamp((1.0 + 0.35 * along) * luma, 0.0, 255.0));
    }
  }
  Picture glaring = clean;
  glaring.luma.data = lit.data();
  TagDetector detector = *TagDetector::open({});
  const std::array<int, 1> ids{1};
  const TagPoints dim = points_of(detector.detect(clean), ids);
  ASSERT_EQ(dim.points.size(), kTagCorners);
  EXPECT_FALSE(dim.points[0].saturated);
  const TagPoints bright = points_of(detector.detect(glaring), ids);
  ASSERT_EQ(bright.points.size(), kTagCorners);
  for (const ImagePoint& corner : bright.points) EXPECT_TRUE(corner.saturated);
  EXPECT_EQ(bright.health.peak_luma, 255.0);
}

TEST(TagLineTest, ATagThatIsNotWantedIsNoPoint) {
  const LineModel model = drawn_model();
  TagDetector detector = *TagDetector::open({});
  test::Sheet sheet = sheet_of(model, Side::kLeft);
  const std::array<int, 1> ids{1};
  const TagPoints found = points_of(detector.detect(sheet.grey()), ids);
  ASSERT_EQ(found.points.size(), kTagCorners);
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    EXPECT_EQ(found.points[k].label, (PointLabel{1, static_cast<int>(k)}));
  }
  EXPECT_NEAR(found.health.peak_luma, test::Sheet::kLight, 2.0);
}

}  // namespace
}  // namespace tripoint
