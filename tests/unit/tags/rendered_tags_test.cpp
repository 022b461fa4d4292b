// Tags as simulated cameras see them, through mosaic, noise and encoding: what detector and line make of them.
#include "rendered_tags.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "capture/mjpeg_decoder.h"
#include "drawn_tag.h"
#include "line/line.h"
#include "tags/tag_points.h"
#include "tags/tag_tracker.h"

namespace tripoint {
namespace {

SimulatedWorld world_of(const SimulationSettings& settings) {
  Result<SimulatedWorld> world = SimulatedWorld::create(settings);
  EXPECT_TRUE(world) << world.error().message;
  return *std::move(world);
}

/// Without distortion: its edges are straight, as the detector takes them.
StereoCalibration pinholes() {
  StereoCalibration rig = default_rig();
  for (const Side side : kBothSides) rig.cameras[side].distortion = {};
  return rig;
}

TEST(RenderedTagsTest, CornersAreMeasuredWhereTheyTrulyAre) {
  SimulationSettings settings = test::tagged_settings();
  settings.rig = pinholes();
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  TagDetector detector = *TagDetector::open({});
  Vec2 sum = Vec2::Zero();
  double squares = 0.0;
  int corners = 0;
  for (std::uint64_t frame = 0; frame < 12; ++frame) {  // once round the paper's circle
    const RenderedFrame& rendered = renderer.render(std::chrono::seconds{frame}, frame);
    const SeenTags seen = detector.detect(picture_of(frame_of(rendered)));
    ASSERT_EQ(seen.tags.size(), 3U);
    for (const SeenTag& tag : seen.tags) {
      ASSERT_EQ(tag.outline.cause, TagCause::kKept) << name(tag.outline.cause);
      const TagTruth& truth = rendered.truth.tags[static_cast<std::size_t>(tag.decoded.id)];
      for (std::size_t k = 0; k < kTagCorners; ++k, ++corners) {
        const Vec2 error(tag.outline.corners_px[k].u_px - truth.corners_px[k].u_px,
                         tag.outline.corners_px[k].v_px - truth.corners_px[k].v_px);
        sum += error;
        squares += error.squaredNorm();
      }
    }
  }
  // Noise allows 0.01 px, the mosaic as much again; the mean of 144 corners a tenth of it.
  EXPECT_LT(std::sqrt(squares / (2.0 * corners)), 0.025);
  EXPECT_LT((sum / corners).norm(), 0.006);
}

TEST(RenderedTagsTest, TheFamilysBitsAreThePublishedOnes) {
  for (std::size_t i = 0; i < test::kRenderedIds.size(); ++i) {
    const TagCells cells = *tag_print("tag36h11", test::kRenderedIds[i]);
    const test::TagCells published = test::tag36h11(test::kCodes36h11[i]);
    ASSERT_EQ(static_cast<std::size_t>(cells.total), published.light.size());
    EXPECT_EQ(cells.across, published.across);
    for (int row = 0; row < cells.total; ++row) {
      for (int column = 0; column < cells.total; ++column) {
        EXPECT_EQ(cells.is_light(column, row),
                  published.light[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
      }
    }
  }
}

TEST(RenderedTagsTest, ATagThatNoFamilyHasIsNotPrinted) {
  EXPECT_EQ(tag_print("tag37h11", 0).error().code, ErrorCode::kOutOfRange);
  const Result<TagCells> beyond = tag_print("tag36h11", 587);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::kOutOfRange);
  EXPECT_NE(beyond.error().message.find("permitted is 0 to 586"), std::string::npos) << beyond.error().message;
  EXPECT_TRUE(tag_print("tag36h11", 586));
  EXPECT_FALSE(tag_print("tag36h11", -1));
}

struct Delivery {
  PixelFormat format;
  ImageSize size;
};

class RenderedFormatsTest : public testing::TestWithParam<Delivery> {};

TEST_P(RenderedFormatsTest, TagsAreMeasuredInEveryFormatAndSize) {
  SimulationSettings settings = test::tagged_settings();
  settings.format = GetParam().format;
  settings.rig = default_rig(GetParam().size);
  const RenderedFrame rendered = render(world_of(settings), Side::kLeft, std::chrono::seconds{3});
  MjpegDecoder jpeg;
  const Result<Picture> picture = settings.format == PixelFormat::kMjpeg
                                      ? jpeg.decode(rendered.pixels, rendered.size)
                                      : Result<Picture>(picture_of(frame_of(rendered)));
  ASSERT_TRUE(picture);
  TagDetector detector = *TagDetector::open({});
  const SeenTags seen = detector.detect(*picture);
  ASSERT_EQ(seen.tags.size(), 3U);
  for (const SeenTag& tag : seen.tags) {
    EXPECT_EQ(tag.outline.cause, TagCause::kKept) << name(tag.outline.cause);
    const TagTruth& truth = rendered.truth.tags[static_cast<std::size_t>(tag.decoded.id)];
    for (std::size_t k = 0; k < kTagCorners; ++k) {  // what the lens bends included
      EXPECT_NEAR(tag.outline.corners_px[k].u_px, truth.corners_px[k].u_px, 0.25);
      EXPECT_NEAR(tag.outline.corners_px[k].v_px, truth.corners_px[k].v_px, 0.25);
    }
  }
}

constexpr ImageSize kLarge{.width_px = 1280, .height_px = 720};
constexpr ImageSize kUsual{.width_px = 640, .height_px = 480};
INSTANTIATE_TEST_SUITE_P(All, RenderedFormatsTest,
                         testing::Values(Delivery{PixelFormat::kYuyv, kUsual}, Delivery{PixelFormat::kMjpeg, kUsual},
                                         Delivery{PixelFormat::kGrey, kUsual}, Delivery{PixelFormat::kYuyv, kLarge},
                                         Delivery{PixelFormat::kMjpeg, kLarge}, Delivery{PixelFormat::kGrey, kLarge}));

TEST(RenderedTagsTest, FromBehindNothingIsDecoded) {
  SimulationSettings settings = test::tagged_settings();
  for (PrintedTag& tag : settings.scene.tags) tag.target_from_tag.linear().setIdentity();
  const RenderedFrame rendered = render(world_of(settings), Side::kLeft, std::chrono::seconds{3});
  EXPECT_TRUE(rendered.truth.tags[0].visible);
  EXPECT_EQ(TagDetector::open({})->detect(picture_of(frame_of(rendered))).tags.size(), 0U);
}

LineModel model_of(const SimulationSettings& settings) {
  LineModel model;
  model.calibration = settings.rig;
  model.rig = *rig_of(settings.rig);
  model.limits.offset_prior_s = 1e-4;
  for (const PrintedTag& printed : settings.scene.tags) {
    TargetTag tag{.id = printed.id, .corners_mm = {}, .uncertainty_mm = 0.0};
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      tag.corners_mm[k] = printed.target_from_tag *
                          Vec3(0.5 * printed.size_mm * Vec3(kTagCornerPlaces[k][0], kTagCornerPlaces[k][1], 0.0));
    }
    model.target.points.push_back({tag.id, printed.target_from_tag.translation(), 0.0, std::nullopt});
    model.target.tags.push_back(tag);
  }
  return model;
}

Observation observed(TagTracker& tracker, const RenderedFrame& rendered, std::uint32_t number) {
  Observation seen;
  seen.side = rendered.truth.side;
  seen.frame = number;
  seen.exposed = rendered.truth.exposed;
  seen.arrived = seen.exposed + std::chrono::milliseconds{40};
  seen.line_time = rendered.line_time;
  Picture picture = picture_of(frame_of(rendered));
  picture.frame = number;
  const SeenTags& tags = tracker.see(picture);
  const TagPoints found = points_of(tags, test::kRenderedIds);
  seen.points = found.points;
  seen.health = found.health;
  seen.coverage = tags.coverage;
  return seen;
}

/// The target turned and moving, before the default rig's distorting lenses and rolling shutters.
TEST(RenderedTagsTest, TheLineFindsThePoseOfTheRenderedTarget) {
  SimulationSettings settings = test::tagged_settings();
  const Isometry3 turned(Eigen::AngleAxisd(0.4, Vec3(0.8, -0.6, 0.0)) * Eigen::AngleAxisd(M_PI, Vec3::UnitX()) *
                         Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  settings.trajectory = {.period = std::chrono::seconds{10}, .reference_from_target = [&](double phase_s) -> Isometry3 {
                           return Eigen::Translation3d(Vec3(-30.0 + 25.0 * phase_s, 10.0, 410.0)) * turned;
                         }};
  const SimulatedWorld world = world_of(settings);
  PerSide<FrameRenderer> renderers{{world, Side::kLeft}, {world, Side::kRight}};
  PerSide<TagTracker> trackers{*TagTracker::open({}), *TagTracker::open({})};
  Line line(std::make_shared<const LineModel>(model_of(settings)));
  std::optional<Measurement> last;
  int followed = 0;
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    for (const Side side : kBothSides) {
      const RenderedFrame& rendered = renderers[side].render(duration_from_seconds(1.0 + frame / 30.0), frame);
      const Observation seen = observed(trackers[side], rendered, frame);
      followed += seen.coverage == Coverage::kRegions ? 1 : 0;
      if (const auto verdict = line.step(seen)) last = verdict;
    }
  }
  EXPECT_GE(followed, 8);  // of 16, four of them decoded by their number
  ASSERT_TRUE(last);
  EXPECT_EQ(last->faults.bits(), 0);
  ASSERT_TRUE(last->pose && last->pose->output_from_target);
  const Isometry3 truth = target_pose_at(settings.trajectory, last->exposed.time_since_epoch());
  const Eigen::AngleAxisd turn(*last->pose->output_from_target * truth.linear().transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << last->pose->position_in_output_mm - truth.translation(), turn.angle() * turn.axis();
  EXPECT_LT(error.head<3>().norm(), 0.2);   // 0.04 px at 410 mm is 0.2 mm in depth
  EXPECT_LT(error.tail<3>().norm(), 2e-3);  // over the 100 mm of the target
  // chi-square of 6 above 30 has a chance of 4e-5
  EXPECT_LT(error.dot(last->pose->noise.ldlt().solve(error)), 30.0);
}

}  // namespace
}  // namespace tripoint
