#include "serve/latch.h"

#include <gtest/gtest.h>

#include <limits>

#include "serve/image.h"
#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

constexpr TimePoint kBegan = kExposed - milliseconds(33);  // of states.h

Edition latched(UnitState state) {
  const Latch latch = filled(requested(Latch{}, kBegan - Duration{1}), state);
  return Edition{std::make_shared<const UnitState>(state), latch, {}};
}

RegisterImage image_of(const Edition& edition, TimePoint now) { return image_at(edition, ServiceState{}, now); }

TEST(LatchTest, TakesAPoseOnlyWhenAllPicturesBeganAfterTheRequest) {
  const UnitState state = unit_state();
  EXPECT_EQ(filled(requested(Latch{}, kBegan), state).outcome, LatchOutcome::kWaiting);
  EXPECT_EQ(filled(requested(Latch{}, kBegan - Duration{1}), state).outcome, LatchOutcome::kFilled);
}

TEST(LatchTest, TakesNoPoseThatByItsStampsUncertaintyMayHaveBegunBeforeTheRequest) {
  Measurement measurement = position_measurement();
  measurement.timing.skew_sigma_s = 0.010;  // k = 2: 20 ms
  const UnitState state = unit_state(measurement);
  EXPECT_EQ(filled(requested(Latch{}, kBegan - milliseconds(20)), state).outcome, LatchOutcome::kWaiting);
  EXPECT_EQ(filled(requested(Latch{}, kBegan - milliseconds(20) - Duration{1}), state).outcome, LatchOutcome::kFilled);
}

TEST(LatchTest, TakesNoPoseWhoseStampsNobodyKnows) {
  for (const double sigma_s : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Measurement measurement = position_measurement();
    measurement.timing.skew_sigma_s = sigma_s;
    EXPECT_EQ(filled(requested(Latch{}, time_from_ns(0)), unit_state(measurement)).outcome, LatchOutcome::kWaiting);
  }
}

TEST(LatchTest, TakesTheFirstPoseAndKeepsIt) {
  const Edition edition = latched(unit_state(position_measurement(7)));
  const Latch later = filled(edition.latch, unit_state(position_measurement(8)));
  EXPECT_EQ(later.copy->published.measurement.sequence, 7U);
}

TEST(LatchTest, AMeasurementWithoutAValidPoseIsNotTaken) {
  const Latch waiting = requested(Latch{}, time_from_ns(0));
  Measurement no_pose = position_measurement();
  no_pose.pose.reset();
  EXPECT_EQ(filled(waiting, unit_state(no_pose)).outcome, LatchOutcome::kWaiting);
  Measurement faulty = position_measurement();
  faulty.faults.insert(Fault::kTimingBound);
  EXPECT_EQ(filled(waiting, unit_state(faulty)).outcome, LatchOutcome::kWaiting);
  UnitState unit_fault = unit_state();
  unit_fault.faults.insert(Fault::kInternal);
  EXPECT_EQ(filled(waiting, unit_fault).outcome, LatchOutcome::kWaiting);
}

TEST(LatchTest, FailsWhenNoPoseCameInTime) {
  const Latch waiting = requested(Latch{}, kExposed);
  EXPECT_EQ(expired(waiting, kExposed + kLatchWait).outcome, LatchOutcome::kWaiting);
  EXPECT_EQ(expired(waiting, kExposed + kLatchWait + Duration{1}).outcome, LatchOutcome::kNoPose);
}

TEST(LatchTest, ANewRequestEmptiesTheCopy) {
  const Edition before = latched(unit_state());
  const RegisterImage image = image_of({before.state, requested(before.latch, kExposed), {}}, kExposed);
  EXPECT_EQ(image[401] & 0x001C, 0x0010);
  EXPECT_EQ(u32_at(image, 410), 0x80000000U);
  EXPECT_EQ(image[33] & 0x1000, 0);
}

TEST(LatchedBlockTest, IsNotValidWhileAKnockIsSuspectedThatItMayHaveBeenMeasuredAfter) {
  const Edition first = latched(unit_state());
  Measurement knocked = position_measurement(70001);
  knocked.pose.reset();
  knocked.faults.insert(Fault::kDecalibration);
  const Edition edition{std::make_shared<const UnitState>(unit_state(knocked)), first.latch, {}};
  EXPECT_NE(image_of(first, kExposed)[401] & 0x0004, 0);
  const RegisterImage image = image_of(edition, kExposed);
  EXPECT_EQ(image[401] & 0x0004, 0);
  EXPECT_EQ(u32_at(image, 410), 0x80000000U);
  EXPECT_EQ(image[33] & 0x1000, 0);
}

TEST(LatchedBlockTest, HoldsThePoseInBothFormatsWhileTheLiveOneMovesOn) {
  const Edition first = latched(unit_state(position_measurement(7)));
  Measurement moved = position_measurement(8);
  moved.pose->position_in_output_mm = Vec3::Zero();
  const Edition edition{std::make_shared<const UnitState>(unit_state(moved)), first.latch, {}};
  const RegisterImage image = image_of(edition, kExposed + milliseconds(50));
  EXPECT_EQ(i32_at(image, 110), 0);
  EXPECT_EQ(image[400], 7);
  EXPECT_EQ(i32_at(image, 410), -18'670);
  EXPECT_EQ(i32_at(image, 414), 457'220);
  EXPECT_EQ(u32_at(image, 444), 7U);
  EXPECT_EQ(image[447], 7);
  EXPECT_EQ(image[448], 7);
  EXPECT_EQ(i16_at(image, 454), 4572);
  EXPECT_EQ(image[463], 7);
  EXPECT_EQ(image[33] & 0x1000, 0x1000);
  EXPECT_EQ(image[401] & 0x1004, 0x1004);
}

TEST(LatchedBlockTest, ItsAgeRunsOnBeyondTheAgeLimit) {
  const RegisterImage image = image_of(latched(unit_state()), kExposed + milliseconds(1500));
  EXPECT_EQ(u32_at(image, 408), 1'500'000U);
  EXPECT_EQ(image[461], 1500);
  EXPECT_EQ(image[401] & 0x0014, 0x0004);
  EXPECT_EQ(image[101] & 0x0014, 0x0010);
}

TEST(LatchedBlockTest, TurnsNotValidAfterTheHoldLimit) {
  const Edition edition = latched(unit_state());
  EXPECT_EQ(image_of(edition, kExposed + std::chrono::seconds(10))[401] & 0x0014, 0x0004);
  const RegisterImage over = image_of(edition, kExposed + std::chrono::seconds(10) + Duration{1});
  EXPECT_EQ(over[401] & 0x0014, 0x0010);
  EXPECT_EQ(over[449] & 0x0014, 0x0010);
  EXPECT_EQ(u32_at(over, 410), 0x80000000U);
  EXPECT_EQ(over[452], 0x8000);
  EXPECT_EQ(over[33] & 0x1000, 0);
}

TEST(LatchedBlockTest, TurnsNotValidWithAnotherSetup) {
  const Edition before = latched(unit_state());
  UnitState changed = unit_state();
  changed.identity.setup = 0x1234;
  const RegisterImage image = image_of({std::make_shared<const UnitState>(changed), before.latch, {}}, kExposed);
  EXPECT_EQ(image[401] & 0x0004, 0);
  EXPECT_EQ(image[446], 0xBEEF);
  EXPECT_EQ(u32_at(image, 410), 0x80000000U);
}

TEST(LatchedBlockTest, NothingLatchedIsNotValid) {
  const RegisterImage image = image_of(edition_of(unit_state()), kExposed);
  EXPECT_EQ(image[401] & 0x001C, 0x0010);
  EXPECT_EQ(u32_at(image, 408), 0xFFFFFFFFU);
  EXPECT_EQ(u32_at(image, 410), 0x80000000U);
  EXPECT_EQ(image[452], 0x8000);
}

}  // namespace
}  // namespace tripoint
