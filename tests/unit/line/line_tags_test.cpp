// Tags instead of LEDs: known by their labels, measured by their corners.
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include "tag_views.h"

namespace tripoint {
namespace {

using bench::add_tag;
using bench::add_tags;
using testing::error_of;
using testing::kPose;
using testing::kSigma_px;
using testing::kViews;
using testing::picture;
using testing::seen;
using testing::Shown;
using testing::tag_model;
using testing::tilted;
using testing::verdicts;

/// The mean of 200 chi-squares of 6 is 6 with a deviation of sqrt(12 / 200) = 0.24; the range is four of them.
void expect_errors_as_stated(const std::vector<Measurement>& measurements, const Isometry3& truth = kPose) {
  double chi2 = 0.0;
  int poses = 0;
  for (const Measurement& one : measurements) {
    if (!one.pose) continue;
    ASSERT_TRUE(one.pose->output_from_target);
    const auto error = error_of(*one.pose, truth);
    chi2 += error.dot(one.pose->noise.ldlt().solve(error));
    ++poses;
  }
  EXPECT_GE(poses, kViews - 1);
  EXPECT_NEAR(chi2 / poses, 6.0, 1.0);
}

/// No pose at all; of the first verdict the cause may be that the cameras' clocks are not known yet.
void expect_only(const std::vector<Measurement>& measurements, Faults faults) {
  ASSERT_GT(measurements.size(), 1U);
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    EXPECT_FALSE(measurements[i].pose) << i;
    if (i > 0) {
      EXPECT_EQ(measurements[i].faults.bits(), faults.bits()) << i;
    }
  }
}

TEST(LineTagsTest, OneTagGivesAPoseThatErrsAsItStates) { expect_errors_as_stated(seen(tag_model(1))); }

TEST(LineTagsTest, ThreeTagsGiveAPoseThatErrsAsItStates) { expect_errors_as_stated(seen(tag_model(3))); }

// The lens bends the edges of 70 px there; left alone, that moves corners by several deviations.
TEST(LineTagsTest, WhereTheLensBendsEdgesThePoseErrsAsItStatesToo) {
  const LineModel model = tag_model(1, 45.0);
  const Isometry3 pose = tilted({140.0, -55.0, 400.0}, 0.3);
  expect_errors_as_stated(seen(model, {.model = {model, model}, .pose = pose}), pose);
}

TEST(LineTagsTest, ThreeCentresByThePapersMethodToo) {
  LineModel model = tag_model(3);
  model.method = Method::kPaper;
  expect_errors_as_stated(seen(model));
}

TEST(LineTagsTest, APointForEachTagAtItsCentre) {
  const LineModel model = tag_model(3);
  const Measurement last = seen(model).back();
  ASSERT_EQ(last.points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(last.points[i].id, model.target.tags[i].id);
    const Vec3 error_mm = last.points[i].in_output_mm - kPose * model.target.points[i].in_target_mm;
    // chi-square of 3 above 25 has a chance of 2e-5
    EXPECT_LT(error_mm.dot(last.points[i].covariance_mm2.ldlt().solve(error_mm)), 25.0);
  }
}

TEST(LineTagsTest, OneOfThreeTagsInBothPicturesIsEnough) {
  const LineModel model = tag_model(3);
  Shown shown{.model = {model, model}};
  shown.model.right.target.tags.truncate(1);
  expect_errors_as_stated(seen(model, shown));
}

TEST(LineTagsTest, FewerThanThreeTagsAreNoPoseByThePapersMethod) {
  LineModel model = tag_model(3);
  model.method = Method::kPaper;
  Shown shown{.model = {model, model}};
  shown.model.right.target.tags.truncate(2);
  expect_only(seen(model, shown), {Fault::kNotSeenLeft, Fault::kNotSeenRight});
}

TEST(LineTagsTest, TagsOfTheTargetInOnePictureAloneAreNotSeenInTheOther) {
  const LineModel model = tag_model(1);
  LineModel none = model;
  none.target.tags.clear();
  expect_only(seen(model, {.model = {model, none}}), {Fault::kNotSeenRight});
  expect_only(seen(model, {.model = {none, model}}), {Fault::kNotSeenLeft});
  expect_only(seen(model, {.model = {none, none}}), {Fault::kNotSeenLeft, Fault::kNotSeenRight});
}

TEST(LineTagsTest, TagsOfNoTargetAreNotSeen) {
  LineModel others = tag_model(1);
  others.target.tags[0].id = 99;
  expect_only(seen(tag_model(1), {.model = {others, others}}), {Fault::kNotSeenLeft, Fault::kNotSeenRight});
}

TEST(LineTagsTest, ATagThatIsThereTwiceIsAmbiguous) {
  const LineModel model = tag_model(1);
  LineModel twice = tag_model(2);
  twice.target.tags[1].id = twice.target.tags[0].id;
  for (const Measurement& one : seen(model, {.model = {twice, model}})) {
    EXPECT_FALSE(one.pose);
    EXPECT_TRUE(one.faults.contains(Fault::kAmbiguous));
  }
}

TEST(LineTagsTest, AnotherTagOfTheSameIdInOnePictureFailsTheEpipolarGate) {
  const LineModel model = tag_model(1);
  LineModel higher = model;
  for (Vec3& corner_mm : higher.target.tags[0].corners_mm) corner_mm += Vec3(0.0, 5.0, 0.0);
  expect_only(seen(model, {.model = {model, higher}}), {Fault::kEpipolarGate});
}

// k1 = -0.5 turns the picture back on itself at 0.54 focal lengths from its middle; the corner of the picture is at
// 0.64.
TEST(LineTagsTest, ACornerOutsideOfTheLensModelIsAGeometryFault) {
  LineModel model = tag_model(1);
  LineModel lens = model;
  lens.calibration.cameras.left.distortion = {-0.5, 0.0, 0.0, 0.0, 0.0};
  lens.rig = *rig_of(lens.calibration);
  std::mt19937_64 random(3);
  std::vector<Event> events;
  for (std::uint32_t view = 0; view < 5; ++view) {
    for (const Side side : kBothSides) {
      Observation one = picture(side, view, 1.0 + view / 30.0);
      add_tags(one, model, kPose, {}, random);
      if (side == Side::kLeft) one.points[0].at = {0.0, 0.0};
      events.emplace_back(one);
    }
  }
  expect_only(verdicts(lens, events), {Fault::kGeometryGate});
}

TEST(LineTagsTest, ByThePapersMethodThreeCentresNearlyOnALineAreNoPose) {
  LineModel model = tag_model(0);
  for (int i = 0; i < 3; ++i) add_tag(model.target, i, 20.0, {40.0 * (i - 1), i == 1 ? 5.0 : 0.0, 0.0});
  model.method = Method::kPaper;
  expect_only(seen(model), {Fault::kNotSeenLeft, Fault::kNotSeenRight});
}

TEST(LineTagsTest, ATagOfAnotherSizeThanTheTargetSaysIsRefused) {
  const LineModel larger = tag_model(1, 31.0);
  expect_only(seen(tag_model(1, 30.0), {.model = {larger, larger}}), {Fault::kGeometryGate});
}

TEST(LineTagsTest, ATagThatHasMovedOnTheToolIsRefused) {
  const LineModel model = tag_model(3);
  LineModel bent = model;
  for (Vec3& corner_mm : bent.target.tags[2].corners_mm) corner_mm += Vec3(0.0, 1.5, 0.0);
  expect_only(seen(model, {.model = {bent, bent}}), {Fault::kGeometryGate});
}

/// The third tag of three as it was glued, against what the target says.
void expect_refused_when_the_third_is_moved_by(const Isometry3& move_mm) {
  const LineModel model = tag_model(3);
  LineModel glued = model;
  const Vec3 centre_mm = model.target.points[2].in_target_mm;
  for (Vec3& corner_mm : glued.target.tags[2].corners_mm) corner_mm = centre_mm + move_mm * (corner_mm - centre_mm);
  expect_only(seen(model, {.model = {glued, glued}}), {Fault::kGeometryGate});
}

// Each corner of these lies within 8 of its own deviations; all of them together are never so far off by chance.
TEST(LineTagsTest, AllCornersTogetherShowASizeThatIsWrongByOneInAHundredAndFifty) {
  const LineModel larger = tag_model(1, 30.2);
  expect_only(seen(tag_model(1, 30.0), {.model = {larger, larger}}), {Fault::kGeometryGate});
}

TEST(LineTagsTest, AllCornersTogetherShowATagThatWasGluedAside) {
  expect_refused_when_the_third_is_moved_by(Isometry3(Eigen::Translation3d(0.15, 0.15, 0.0)));
}

TEST(LineTagsTest, AllCornersTogetherShowATagThatWasGluedAskew) {
  expect_refused_when_the_third_is_moved_by(Isometry3(Eigen::AngleAxisd(0.007, Vec3::UnitZ())));
}

TEST(LineTagsTest, AllCornersTogetherShowAPlateThatIsBent) {
  expect_refused_when_the_third_is_moved_by(Isometry3(Eigen::AngleAxisd(0.012, Vec3::UnitX())));
}

TEST(LineTagsTest, ByThePapersMethodAFourthCentreThatDoesNotFitIsRefused) {
  LineModel model = tag_model(3);
  add_tag(model.target, 50, 30.0, {-50.0, 40.0, 0.0});
  model.method = Method::kPaper;
  LineModel glued = model;
  for (Vec3& corner_mm : glued.target.tags[3].corners_mm) corner_mm += Vec3(0.2, 0.2, 0.0);
  expect_only(seen(model, {.model = {glued, glued}}), {Fault::kGeometryGate});
}

// As a mirror shows it: the corners run the other way round, as those of a tag seen from behind.
TEST(LineTagsTest, ATagSeenFromBehindIsRefused) {
  const LineModel model = tag_model(1);
  LineModel mirrored = model;
  std::swap(mirrored.target.tags[0].corners_mm[0], mirrored.target.tags[0].corners_mm[1]);
  std::swap(mirrored.target.tags[0].corners_mm[2], mirrored.target.tags[0].corners_mm[3]);
  expect_only(seen(model, {.model = {mirrored, mirrored}}), {Fault::kGeometryGate});
}

// Mirrored about the middle of all corners, the far tag would lie behind the cameras: that tilt cannot be judged.
TEST(LineTagsTest, ATiltThatCannotBeTestedIsAmbiguousAndNotBelieved) {
  LineModel model = tag_model(3, 20.0);
  for (TargetTag& tag : model.target.tags) {
    for (Vec3& corner_mm : tag.corners_mm) corner_mm *= 0.5;
  }
  add_tag(model.target, 50, 60.0, {-40.0, 0.0, 900.0});
  model.volume.reset();
  expect_only(seen(model, {.model = {model, model}, .pose = tilted({0.0, 0.0, 260.0}, 0.0)}), {Fault::kAmbiguous});
}

}  // namespace
}  // namespace tripoint
