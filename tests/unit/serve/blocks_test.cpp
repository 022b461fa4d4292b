// The 16-bit block, the points, the cameras and the timing: where they stand and what they do at their limits.
#include <gtest/gtest.h>

#include <cmath>

#include "serve/image.h"
#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

constexpr TimePoint kNow = kExposed + milliseconds(12);

RegisterImage image_of(const UnitState& state) { return image_at(edition_of(state), ServiceState{}, kNow); }

TEST(SingleBlockTest, GivesTenthsOfAMillimetre) {
  const RegisterImage image = image_of(unit_state());
  EXPECT_EQ(image[300], image[100]);
  EXPECT_EQ(image[303], 41);
  EXPECT_EQ(i16_at(image, 304), -187);
  EXPECT_EQ(i16_at(image, 305), -503);  // -502.5, away from zero
  EXPECT_EQ(i16_at(image, 306), 4572);
  EXPECT_EQ(image[310], 20);
  EXPECT_EQ(image[312], 200);
  EXPECT_EQ(image[313], 12);
  EXPECT_EQ(image[314], 0xBEEF);
  EXPECT_EQ(image[315], image[300]);
}

TEST(SingleBlockTest, APositionThatDoesNotFitIsNotValidThereAlone) {
  Measurement measurement = position_measurement();
  measurement.pose->position_in_output_mm.x() = 3276.8;  // one step beyond a signed 16-bit number of 0.1 mm
  const RegisterImage image = image_of(unit_state(measurement));
  for (std::size_t address = 304; address < 307; ++address) EXPECT_EQ(image[address], 0x8000);
  EXPECT_EQ(image[301] & 0x0004, 0);
  EXPECT_EQ(image[101] & 0x0004, 0x0004);
  measurement.pose->position_in_output_mm.x() = 3276.7;
  EXPECT_EQ(i16_at(image_of(unit_state(measurement)), 304), 32767);
}

TEST(SingleBlockTest, ALargeUncertaintyIsClipped) {
  Measurement measurement = position_measurement();
  measurement.pose->noise(2, 2) = 1e4;  // standard deviation 100 mm
  EXPECT_EQ(image_of(unit_state(measurement))[312], 0xFFFF);
}

TEST(PointsTest, StandTenRegistersApart) {
  Measurement measurement = position_measurement();
  MeasuredPoint second;
  second.in_output_mm = Vec3(1.0, -2.0, 300.5);
  second.covariance_mm2 = Matrix3::Identity() * 2500.0;  // expanded 100 mm: more than 65535 um
  second.residual_px = 0.5;
  second.saturated = second.weak = true;
  measurement.points.push_back(second);
  const RegisterImage image = image_of(unit_state(measurement));
  EXPECT_EQ(image[500], image[100]);
  EXPECT_EQ(image[501], 2);
  EXPECT_EQ(i32_at(image, 502), -18'670);
  EXPECT_EQ(image[508], 1);
  EXPECT_EQ(image[509], 200);
  EXPECT_EQ(image[511], 0);
  EXPECT_EQ(i32_at(image, 514), -2'000);
  EXPECT_EQ(image[518], 0);
  EXPECT_EQ(image[519], 0xFFFF);
  EXPECT_EQ(image[520], 500);
  EXPECT_EQ(image[521], 3);
  EXPECT_EQ(u32_at(image, 522), 0x80000000U);
  EXPECT_EQ(image[622], image[500]);
}

TEST(CamerasTest, StandSixteenRegistersApart) {
  UnitState state = unit_state();
  state.cameras.left = {
      registers::CameraState::kDelivering, 29.97, 10'000.0, 16.0, -5.5, 70'001, 3, 250.0, 12.4, 0.77, 2.1, 11.8, 2};
  state.cameras.right.frames_per_second = 700.0;
  const RegisterImage image = image_of(state);
  EXPECT_EQ(image[700], 2);
  EXPECT_EQ(image[701], 2997);
  EXPECT_EQ(u32_at(image, 702), 10'000U);
  EXPECT_EQ(image[704], 16);
  EXPECT_EQ(i16_at(image, 705), -55);
  EXPECT_EQ(u32_at(image, 706), 70'001U);
  EXPECT_EQ(image[708], 3);
  EXPECT_EQ(image[709], 250);
  EXPECT_EQ(image[710], 12);
  EXPECT_EQ(image[711], 770);
  EXPECT_EQ(image[712], 2);
  EXPECT_EQ(image[713], 210);
  EXPECT_EQ(image[714], 1180);
  EXPECT_EQ(image[715], 0);
  EXPECT_EQ(image[717], 0xFFFF);  // faster than the register can tell: that or more
  EXPECT_EQ(u32_at(image, 718), 0xFFFFFFFFU);
  EXPECT_EQ(image[720], 0xFFFF);
  EXPECT_EQ(image[721], 0x8000);
  EXPECT_EQ(image[729], 0xFFFF);
  EXPECT_EQ(image[730], 0xFFFF);
}

TEST(TimingTest, StandsBehindTheCameras) {
  UnitState state = unit_state();
  Timing& timing = state.newest->measurement.timing;
  timing.skew_s = -0.0042;
  timing.skew_sigma_s = 0.00005;
  timing.uncorrected_cost_mm = 1.25;
  state.newest->measurement.side_length_error_mm = -0.031;
  state.newest->measurement.decalibration_mm = 0.2;
  state.health = {850.0, 1900.0, 48.3, 61.0};
  const RegisterImage image = image_of(state);
  EXPECT_EQ(i32_at(image, 732), -4'200);
  EXPECT_EQ(u32_at(image, 734), 100U);
  EXPECT_EQ(u32_at(image, 736), 1'250U);
  EXPECT_EQ(u32_at(image, 738), 850U);
  EXPECT_EQ(u32_at(image, 740), 1'900U);
  EXPECT_EQ(image[742], 52);
  EXPECT_EQ(i16_at(image, 743), -31);
  EXPECT_EQ(image[744], 200);
  EXPECT_EQ(i16_at(image, 745), 483);
  EXPECT_EQ(image[746], 61);
}

TEST(TimingTest, WhatTheSkewCostsIsUnknownWithoutAPose) {
  Measurement measurement = position_measurement();
  measurement.pose.reset();
  measurement.faults.insert(Fault::kNotSeenLeft);
  const RegisterImage image = image_of(unit_state(measurement));
  EXPECT_EQ(u32_at(image, 736), 0xFFFFFFFFU);
  EXPECT_EQ(i32_at(image, 732), 0) << "the skew itself is known";
}

TEST(StatusTest, EveryUnitFlagHasItsBit) {
  UnitState state;
  state.flags = {true, true, true, true, true, true};
  EXPECT_EQ(image_of(state)[33], 0x23D1);  // ready, stale, calibrated, registered, clock, simulated, verified
}

TEST(StatusTest, AStoppedUnitHasNoValidPoseHoweverFreshItIs) {
  UnitState state = unit_state();
  state.state = registers::State::kStopped;
  const RegisterImage image = image_of(state);
  EXPECT_EQ(image[36], 6);
  for (const std::size_t status : {33U, 101U, 201U, 251U, 301U}) {
    EXPECT_EQ(image[status] & 0x001E, 0x0010) << status;  // not tracking, neither part valid, stale
  }
  EXPECT_EQ(u32_at(image, 110), 0x80000000U);
  EXPECT_EQ(image[501], 0);
  EXPECT_EQ(u32_at(image, 108), 12'000U) << "time and age stay";
}

TEST(StatusTest, FaultsAndWarningsHaveTheBitsOfTheContract) {
  for (std::size_t bit = 0; bit < kFaultNames.size(); ++bit) {
    UnitState state = unit_state();
    state.faults.insert(static_cast<Fault>(bit));
    EXPECT_EQ(image_of(state)[34], 1U << bit) << kFaultNames[bit];
    EXPECT_EQ(image_of(state)[33] & 0x0004, 0) << kFaultNames[bit];
  }
  EXPECT_EQ(static_cast<int>(Fault::kInternal), static_cast<int>(registers::FaultBit::kInternal));
  EXPECT_EQ(static_cast<int>(Fault::kTimingBound), static_cast<int>(registers::FaultBit::kTimingBound));
  EXPECT_EQ(static_cast<int>(Warning::kRefusedClients), static_cast<int>(registers::WarningBit::kRefusedClients));
  EXPECT_EQ(static_cast<int>(Warning::kResourceMissing), static_cast<int>(registers::WarningBit::kResourceMissing));
  EXPECT_EQ(static_cast<int>(Warning::kLightUnproved), static_cast<int>(registers::WarningBit::kLightUnproved));
}

}  // namespace
}  // namespace tripoint
