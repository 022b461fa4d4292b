#include "serve/image.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

constexpr TimePoint kNow = kExposed + milliseconds(12);

RegisterImage image_of(const UnitState& state, TimePoint now = kNow) {
  return image_at(edition_of(state), ServiceState{}, now);
}

TEST(ImageTest, IdentityStandsWhereTheMapSays) {
  const RegisterImage image = image_of(unit_state());
  EXPECT_EQ(image[0], 0x5450);
  EXPECT_EQ(image[1], 1);
  EXPECT_EQ(image[2], 2);
  EXPECT_EQ(image[3], 1000);
  EXPECT_EQ(u32_at(image, 4), 0x01020304U);
  EXPECT_EQ(f32_at(image, 6), 123456.0F);
  EXPECT_EQ(u32_at(image, 8), 0x00C0FFEEU);
  EXPECT_EQ(image[12], 7);
  EXPECT_EQ(image[13], 1);
  EXPECT_EQ(u32_at(image, 14), 0x89ABCDEFU);
  EXPECT_EQ(u32_at(image, 16), 0x01234567U);
}

TEST(ImageTest, StateStandsWhereTheMapSays) {
  UnitState state = unit_state();
  state.warnings.insert(Warning::kFramesDropped);
  ServiceState service;
  service.clients = 9;
  service.command = {0x0105, registers::CommandState::kFailed, registers::CommandResult::kNoPoseInTime, 3};
  const RegisterImage image = image_at(edition_of(state), service, kNow);
  EXPECT_EQ(image[32], 41);
  EXPECT_EQ(image[33], 0x0067);  // ready, tracking, position valid, degraded, calibrated
  EXPECT_EQ(image[34], 0);
  EXPECT_EQ(image[35], 1U << 5U);
  EXPECT_EQ(image[36], 1);
  EXPECT_EQ(image[37], 9);
  EXPECT_EQ(u32_at(image, 38), 5U);
  EXPECT_EQ(image[40], 0x0105);
  EXPECT_EQ(image[41], 3);
  EXPECT_EQ(image[42], 3);
  EXPECT_EQ(image[43], 3);
}

TEST(ImageTest, MeasuredPoseIsGivenAsIntegers) {
  const RegisterImage image = image_of(unit_state());
  EXPECT_EQ(image[100], 70000 - 65536);
  EXPECT_EQ(image[101] & 0x021C, 0x0004);
  EXPECT_EQ(bits_at(image, 104, 4), 1'700'000'005'000'000'000U);
  EXPECT_EQ(u32_at(image, 108), 12'000U);
  EXPECT_EQ(i32_at(image, 110), -18'670);
  EXPECT_EQ(i32_at(image, 112), -50'250);
  EXPECT_EQ(i32_at(image, 114), 457'220);
  EXPECT_EQ(u32_at(image, 130), 20'000U);  // 2 x 0.01 mm in nm
  EXPECT_EQ(u32_at(image, 132), 40'000U);
  EXPECT_EQ(u32_at(image, 134), 200'000U);
  EXPECT_EQ(image[142], 43);
  EXPECT_EQ(image[143], 1);
  EXPECT_EQ(u32_at(image, 144), 70'000U);
  EXPECT_EQ(image[146], 0xBEEF);
  EXPECT_EQ(image[147], image[100]);
}

TEST(ImageTest, MeasuredPoseIsGivenAsFloats) {
  const RegisterImage image = image_of(unit_state());
  EXPECT_EQ(image[200], image[247]);
  EXPECT_EQ(bits_at(image, 204, 4), bits_at(image, 104, 4));
  EXPECT_FLOAT_EQ(f32_at(image, 208), 12.0F);
  EXPECT_FLOAT_EQ(f32_at(image, 210), -18.67F);
  EXPECT_FLOAT_EQ(f32_at(image, 214), 457.22F);
  EXPECT_FLOAT_EQ(f32_at(image, 234), 0.2F);
  EXPECT_FLOAT_EQ(f32_at(image, 242), 0.043F);
  EXPECT_EQ(u32_at(image, 244), 70'000U);
  EXPECT_EQ(image[246], 0xBEEF);
}

TEST(ImageTest, WithoutOrientationEverythingOfItIsUnknown) {
  const RegisterImage image = image_of(unit_state());
  for (std::size_t address = 116; address < 130; address += 2)
    EXPECT_EQ(u32_at(image, address), 0x80000000U) << address;
  for (std::size_t address = 136; address < 142; address += 2)
    EXPECT_EQ(u32_at(image, address), 0xFFFFFFFFU) << address;
  for (std::size_t address = 216; address < 230; address += 2)
    EXPECT_TRUE(std::isnan(f32_at(image, address))) << address;
  for (std::size_t address = 307; address < 310; ++address) EXPECT_EQ(image[address], 0x8000) << address;
}

TEST(ImageTest, WithAFaultNoPoseButCauseAndTime) {
  Measurement measurement = position_measurement();
  measurement.faults.insert(Fault::kOutsideVolume);
  const RegisterImage image = image_of(unit_state(measurement));
  EXPECT_EQ(image[102], 1U << 8U);
  EXPECT_EQ(image[101] & 0x000C, 0);
  EXPECT_EQ(bits_at(image, 104, 4), 1'700'000'005'000'000'000U);
  for (std::size_t address = 110; address < 116; address += 2) EXPECT_EQ(u32_at(image, address), 0x80000000U);
  for (std::size_t address = 130; address < 136; address += 2) EXPECT_EQ(u32_at(image, address), 0xFFFFFFFFU);
  for (std::size_t address = 304; address < 307; ++address) EXPECT_EQ(image[address], 0x8000);
}

TEST(ImageTest, TheMountIsWatchedAsLongAsAPoseWouldBeFreshWithOrWithoutATarget) {
  Measurement measurement = position_measurement();
  EXPECT_EQ(image_of(unit_state(measurement))[33] & 0x4000, 0);
  measurement.mount_watched = true;
  measurement.pose.reset();
  measurement.faults.insert(Fault::kNotSeenLeft);
  UnitState state = unit_state(measurement);
  state.pose_since_start = false;
  for (const std::size_t status : {33U, 101U, 201U, 301U}) {
    EXPECT_EQ(image_of(state, kExposed + milliseconds(200))[status] & 0x4000, 0x4000) << status;
    EXPECT_EQ(image_of(state, kExposed + milliseconds(201))[status] & 0x4000, 0) << status;
  }
  state.state = registers::State::kStopped;
  EXPECT_EQ(image_of(state, kExposed + milliseconds(1))[33] & 0x4000, 0);
}

TEST(ImageTest, APoseOlderThanTheLimitIsStaleInEveryLiveBlock) {
  const UnitState state = unit_state();
  const RegisterImage fresh = image_of(state, kExposed + milliseconds(200));
  const RegisterImage stale = image_of(state, kExposed + milliseconds(200) + Duration{1});
  for (const std::size_t status : {33U, 101U, 201U, 301U}) {
    EXPECT_EQ(fresh[status] & 0x0014, 0x0004) << status;
    EXPECT_EQ(stale[status] & 0x0014, 0x0010) << status;
  }
  EXPECT_EQ(stale[251] & 0x0014, 0x0010);
  EXPECT_EQ(u32_at(stale, 110), 0x80000000U);
  EXPECT_TRUE(std::isnan(f32_at(stale, 210)));
  EXPECT_EQ(stale[304], 0x8000);
  EXPECT_EQ(stale[501], 0);
  EXPECT_EQ(u32_at(stale, 502), 0x80000000U);
}

TEST(ImageTest, AgeStopsBelowTheNumberThatMeansUnknown) {
  const UnitState state = unit_state();
  EXPECT_EQ(u32_at(image_of(state, kExposed + std::chrono::hours(2)), 108), 0xFFFFFFFEU);
  EXPECT_EQ(image_of(state, kExposed + std::chrono::hours(2))[313], 0xFFFF);
  EXPECT_EQ(u32_at(image_of(state, kExposed - milliseconds(1)), 108), 0U);
}

TEST(ImageTest, BeforeTheFirstVerdictNothingIsKnown) {
  UnitState state;
  state.faults.insert(Fault::kLeftCameraLost);
  const RegisterImage image = image_of(state);
  EXPECT_EQ(image[101] & 0x001C, 0x0010);
  EXPECT_EQ(image[102], 2);
  EXPECT_EQ(u32_at(image, 108), 0xFFFFFFFFU);
  EXPECT_TRUE(std::isnan(f32_at(image, 208)));
  EXPECT_EQ(u32_at(image, 110), 0x80000000U);
  EXPECT_EQ(image[142], 0xFFFF);
  EXPECT_EQ(u32_at(image, 732), 0x80000000U);
  EXPECT_EQ(u32_at(image, 734), 0xFFFFFFFFU);
}

TEST(ImageTest, AgeIsUnknownUntilThereHasBeenAPose) {
  Measurement measurement = position_measurement();
  measurement.pose.reset();
  measurement.faults.insert(Fault::kNotSeenLeft);
  UnitState state = unit_state(measurement);
  state.pose_since_start = false;
  EXPECT_EQ(u32_at(image_of(state), 108), 0xFFFFFFFFU);
  state.pose_since_start = true;
  EXPECT_EQ(u32_at(image_of(state), 108), 12'000U);
}

TEST(ImageTest, TheTimeOfExposureIsUnknownUntilThereHasBeenAPicture) {
  UnitState state = unit_state();
  state.exposure_since_start = state.pose_since_start = false;
  EXPECT_EQ(bits_at(image_of(state), 104, 4), 0U);
  EXPECT_EQ(bits_at(image_of(state), 204, 4), 0U);
  state.exposure_since_start = true;
  EXPECT_NE(bits_at(image_of(state), 104, 4), 0U);
}

TEST(ImageTest, PredictionThatDoesNotExistIsNotValid) {
  const RegisterImage image = image_of(unit_state());
  EXPECT_EQ(image[250], image[297]);
  EXPECT_EQ(image[251] & 0x000C, 0);
  EXPECT_TRUE(std::isnan(f32_at(image, 258)));
  for (std::size_t address = 260; address < 292; address += 2)
    EXPECT_TRUE(std::isnan(f32_at(image, address))) << address;
  EXPECT_EQ(image[296], 0xBEEF);
}

TEST(ImageTest, APoseWithoutAFiniteNumberIsNotValid) {
  Measurement measurement = position_measurement();
  measurement.pose->position_in_output_mm.y() = std::nan("");
  const RegisterImage image = image_of(unit_state(measurement));
  EXPECT_EQ(image[101] & 0x0004, 0);
  EXPECT_EQ(u32_at(image, 110), 0x80000000U);
}

TEST(ImageTest, RegistersThatAreNotAssignedReadZero) {
  const RegisterImage image = image_of(unit_state());
  std::array<bool, RegisterImage::kSize> assigned{};
  for (const registers::Row& row : registers::kTable) {
    for (std::size_t word = 0; word < row.words; ++word) assigned[row.address + word] = true;
  }
  for (std::size_t address = 0; address < RegisterImage::kSize; ++address) {
    if (assigned[address]) continue;
    EXPECT_EQ(image[address], 0) << address;
  }
}

}  // namespace
}  // namespace tripoint
