#include "line/match/datum.h"

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"

namespace tripoint {
namespace {

const Vec3 kDatum{-80.0, 95.0, 620.0};
const Vec3 kTarget{10.0, 15.0, 400.0};
constexpr double kRadius_mm = 10.0;

LineModel watched_model() {
  LineModel model = testing::webcam_model();
  model.datum = Datum{kDatum, 0.2, kRadius_mm};
  return model;
}

void add(Aligned& seen, Side side, const RawPixel& at) {
  seen.points[side].push_back(AlignedPoint{testing::spot_at(at, 0.05), Vec2::Zero(), Matrix2::Zero()});
  ++seen.spots[side];
}

RawPixel pixel(const LineModel& model, Side side, const Vec3& at_mm) {
  return testing::pixel_of(model, side, testing::at_rest(at_mm), 0.0, 0.0);
}

Aligned seen_by(const LineModel& model, const std::vector<Vec3>& lights_mm) {
  Aligned seen;
  seen.due = seen.common_time = true;
  for (const Vec3& light_mm : lights_mm) {
    for (const Side side : kBothSides) add(seen, side, pixel(model, side, light_mm));
  }
  return seen;
}

TEST(DatumTest, TheDatumIsTakenOutAndTheOnlyOtherPairIsTheTarget) {
  const LineModel model = watched_model();
  for (const auto& lights : {std::vector<Vec3>{kDatum, kTarget}, std::vector<Vec3>{kTarget, kDatum}}) {
    const Pairs found = match(seen_by(model, lights), model);
    EXPECT_TRUE(found.faults.empty());
    ASSERT_EQ(found.pairs.size(), 1U);
    EXPECT_EQ(found.pairs[0].id, 1);
    EXPECT_EQ(found.pairs[0].points.left.seen.at.u_px, pixel(model, Side::kLeft, kTarget).u_px);
    ASSERT_TRUE(found.datum);
    EXPECT_EQ(found.datum->id, 0);
    EXPECT_EQ(found.datum->points.right.seen.at.u_px, pixel(model, Side::kRight, kDatum).u_px);
  }
}

TEST(DatumTest, AloneItIsNeverTheTarget) {
  LineModel model = watched_model();
  model.volume.reset();  // nothing but its place tells it from the target
  const Pairs found = match(seen_by(model, {kDatum}), model);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_TRUE(found.faults.contains(Fault::kNotSeenLeft));
  EXPECT_TRUE(found.faults.contains(Fault::kNotSeenRight));
  EXPECT_TRUE(found.datum);
  model.datum.reset();
  EXPECT_EQ(match(seen_by(model, {kDatum}), model).pairs.size(), 1U);
}

TEST(DatumTest, ALightIsTheDatumWithinItsRadiusInSpace) {
  const LineModel model = watched_model();
  for (const Vec3& direction : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitY()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())}) {
    EXPECT_TRUE(match(seen_by(model, {kTarget, kDatum + 0.98 * kRadius_mm * direction}), model).datum)
        << direction.transpose();
    EXPECT_FALSE(match(seen_by(model, {kTarget, kDatum + 1.02 * kRadius_mm * direction}), model).datum)
        << direction.transpose();
  }
}

TEST(DatumTest, ItIsSeenAlsoOffItsEpipolarPlane) {
  const LineModel model = watched_model();
  Aligned seen = seen_by(model, {kTarget});
  add(seen, Side::kLeft, pixel(model, Side::kLeft, kDatum));
  RawPixel knocked = pixel(model, Side::kRight, kDatum);
  knocked.v_px += 5.0;
  add(seen, Side::kRight, knocked);
  const Pairs found = match(seen, model);
  EXPECT_TRUE(found.faults.empty());
  ASSERT_TRUE(found.datum);
  EXPECT_GT(std::abs(found.datum->epipolar_px), 2.0);
}

TEST(DatumTest, OfTwoThatCouldBeItNoneIsAndNoneIsTheTarget) {
  const LineModel model = watched_model();
  const Pairs found = match(seen_by(model, {kDatum, kDatum + Vec3(6.0, 0.0, 0.0), kTarget}), model);
  EXPECT_FALSE(found.datum);
  EXPECT_EQ(found.faults, Faults{Fault::kAmbiguous});
  ASSERT_EQ(found.pairs.size(), 1U);
  EXPECT_EQ(found.pairs[0].points.left.seen.at.u_px, pixel(model, Side::kLeft, kTarget).u_px);

  const Sifted sifted = without_datum(seen_by(model, {kDatum, kDatum + Vec3(6.0, 0.0, 0.0)}), model);
  EXPECT_TRUE(sifted.others.points.left.empty());
  EXPECT_TRUE(sifted.others.points.right.empty());
  EXPECT_EQ(sifted.others.spots, (PerSide<std::uint16_t>{0, 0}));
}

TEST(DatumTest, ATargetInLineWithTheDatumInOnePictureIsStillFound) {
  const LineModel model = watched_model();
  const Vec3 eye = model.rig.camera_from_rig.left.inverse().translation();
  const Vec3 before = eye + 0.6 * (kDatum + Vec3(2.0, 2.0, 0.0) - eye);
  const Pairs found = match(seen_by(model, {kDatum, before}), model);
  EXPECT_TRUE(found.datum);
  ASSERT_EQ(found.pairs.size(), 1U);
  EXPECT_EQ(found.pairs[0].points.right.seen.at.u_px, pixel(model, Side::kRight, before).u_px);
}

TEST(DatumTest, SpotsThatAreNotAlikeAreNoEvidenceAndNoTarget) {
  const LineModel model = watched_model();
  Aligned seen = seen_by(model, {kDatum, kTarget});
  seen.points.left[0].seen.amplitude *= 4.1;
  const Pairs found = match(seen, model);
  EXPECT_FALSE(found.datum);
  EXPECT_EQ(found.pairs.size(), 1U);
  EXPECT_TRUE(found.faults.empty());
}

TEST(DatumTest, BehindACameraItIsNotLookedFor) {
  LineModel model = watched_model();
  model.datum->in_rig_mm = -kDatum;
  EXPECT_FALSE(match(seen_by(model, {kTarget}), model).datum);
}

TEST(DatumTest, WithoutACalibrationNothingIsTheDatum) {
  LineModel model = watched_model();
  model.calibration_fits = false;
  EXPECT_FALSE(match(seen_by(model, {kDatum}), model).datum);
}

}  // namespace
}  // namespace tripoint
