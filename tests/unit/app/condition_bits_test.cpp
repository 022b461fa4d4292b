// Each bit of registers 34 and 35 comes with its cause and goes with it: from what the cameras see to the registers.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "caused_conditions.h"
#include "contract/registers.h"
#include "places.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

using namespace tripoint::test;
using registers::BitName;

unsigned mask_of(std::span<const BitName> bits, std::string_view name) {
  for (const BitName& bit : bits) {
    if (bit.name == name) return 1U << bit.bit;
  }
  ADD_FAILURE() << "the map has no " << name;
  return 0;
}

bool has_pose(const RegisterImage& image) { return (image[101] & 0x0004U) != 0; }

void expect_a_pose_and_nothing_to_say(const RegisterImage& image) {
  EXPECT_TRUE(has_pose(image));
  EXPECT_EQ(image[34], 0);
  EXPECT_EQ(image[35], 0);
  EXPECT_EQ(image[33] & 0x0020U, 0U) << "degraded";
}

class FaultBitsTest : public ::testing::TestWithParam<Cause> {};

TEST_P(FaultBitsTest, ComesWithItsCauseTakesThePoseAndGoesWithIt) {
  Unit unit(GetParam());
  RegisterImage image = unit.next();
  while (unit.next_s() < kBegins_s) image = unit.next();
  expect_a_pose_and_nothing_to_say(image);
  while (unit.next_s() < kEnds_s) image = unit.next();
  const unsigned mask = mask_of(registers::kFaultBits, GetParam().bit);
  for (const std::size_t faults : {34U, 102U, 202U, 302U}) EXPECT_EQ(image[faults], mask) << faults;
  EXPECT_FALSE(has_pose(image));
  while (unit.next_s() < kOver_s) image = unit.next();
  expect_a_pose_and_nothing_to_say(image);
}

class WarningBitsTest : public ::testing::TestWithParam<Cause> {};

TEST_P(WarningBitsTest, ComesWithItsCauseLeavesThePoseAndGoesTenSecondsAfterIt) {
  Unit unit(GetParam());
  RegisterImage image = unit.next();
  while (unit.next_s() < kBegins_s) image = unit.next();
  expect_a_pose_and_nothing_to_say(image);
  const unsigned mask = mask_of(registers::kWarningBits, GetParam().bit);
  unsigned of_a_pose = 0;
  while (unit.next_s() < kEnds_s) {
    image = unit.next();
    EXPECT_TRUE(has_pose(image));
    of_a_pose |= image[103];
  }
  EXPECT_EQ(of_a_pose, mask);
  EXPECT_EQ(image[35], mask);
  EXPECT_EQ(image[33] & 0x0020U, 0x0020U) << "degraded";
  while (unit.next_s() < kEnds_s + 9.9) image = unit.next();
  EXPECT_EQ(image[103], 0) << "the cause has gone";
  EXPECT_EQ(image[35], mask) << "who looks now and then still sees it";
  while (unit.next_s() < kOver_s) image = unit.next();
  expect_a_pose_and_nothing_to_say(image);
}

const auto kByName = [](const ::testing::TestParamInfo<Cause>& cause) { return std::string(cause.param.bit); };
INSTANTIATE_TEST_SUITE_P(Bits, FaultBitsTest, ::testing::ValuesIn(causes_of_faults()), kByName);
INSTANTIATE_TEST_SUITE_P(Bits, WarningBitsTest, ::testing::ValuesIn(causes_of_warnings()), kByName);

/// What is so from the start to the end of a unit's run: the demo with one thing set up in another way.
struct SetupCause {
  std::string_view bit;
  std::vector<std::string> overrides;
};

/// The demo's calibration, with cameras that say nothing of who they are.
std::string calibration_without_serials(const std::filesystem::path& folder) {
  std::ifstream demo(top_folder() / "deploy/demo/calibration.toml");
  std::ofstream without(folder / "calibration.toml");
  for (std::string line; std::getline(demo, line);) {
    without << (line.starts_with("serial = ") ? "serial = \"\"" : line) << '\n';
  }
  return (folder / "calibration.toml").string();
}

RegisterImage image_of_demo(const std::vector<std::string>& overrides) {
  const Result<UnitSetup> setup = load_config(top_folder() / "deploy/demo/demo.toml", overrides).and_then(unit_setup);
  EXPECT_TRUE(setup) << setup.error().message;
  const SetClock clock;
  Publication publication{UnitState{}};
  publication.publish(UnitReport(setup->constants, clock.now()).state({}, clock), clock.now());
  return image_at(publication.newest(clock.now()), ServiceState{}, clock.now());
}

std::vector<SetupCause> causes_in_the_setup(const std::filesystem::path& folder) {
  return {{"no_calibration", {"calibration.file="}},
          {"no_unique_serial", {"calibration.file=" + calibration_without_serials(folder)}},
          {"light_unproved", {"target.file="}}};
}

TEST(ConditionBitsTest, WhatIsSoBySetupIsSaidByThatSetupAlone) {
  const ScratchFolder folder;
  EXPECT_EQ(image_of_demo({})[34], 0);
  EXPECT_EQ(image_of_demo({})[35], 0);
  for (const SetupCause& cause : causes_in_the_setup(folder.path())) {
    const bool fault = cause.bit == "no_calibration";
    const RegisterImage image = image_of_demo(cause.overrides);
    EXPECT_EQ(image[34], fault ? mask_of(registers::kFaultBits, cause.bit) : 0U) << cause.bit;
    EXPECT_EQ(image[35], fault ? 0U : mask_of(registers::kWarningBits, cause.bit)) << cause.bit;
  }
}

TEST(ConditionBitsTest, EveryBitOfTheMapIsCausedHereOrNamedHere) {
  const std::multiset<std::string_view> elsewhere{"refused_clients"};  // modbus_server_test.cpp
  const std::multiset<std::string_view> of_later_features{"calibration_old", "temperature", "disk_nearly_full",
                                                          "warm_up", "resource_missing"};
  const ScratchFolder folder;
  std::multiset<std::string_view> covered = elsewhere;
  covered.insert(of_later_features.begin(), of_later_features.end());
  for (const Cause& cause : causes_of_faults()) covered.insert(cause.bit);
  for (const Cause& cause : causes_of_warnings()) covered.insert(cause.bit);
  for (const SetupCause& cause : causes_in_the_setup(folder.path())) covered.insert(cause.bit);
  std::multiset<std::string_view> of_the_map;
  for (const BitName& bit : registers::kFaultBits) of_the_map.insert(bit.name);
  for (const BitName& bit : registers::kWarningBits) of_the_map.insert(bit.name);
  EXPECT_EQ(covered, of_the_map);
}

}  // namespace
}  // namespace tripoint
