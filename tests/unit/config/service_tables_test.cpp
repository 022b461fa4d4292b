#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config_text.h"

namespace tripoint {
namespace {

using testing::config_with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::message_with;

TEST(VolumeConfigTest, TheCornersAreRead) {
  const VolumeConfig volume = config_with({"volume.min_mm=[-1, -2, 3.5]"})->volume;
  EXPECT_EQ(volume.min_mm, Vec3(-1.0, -2.0, 3.5));
  EXPECT_EQ(volume.max_mm, Vec3(150.0, 150.0, 600.0));
}

TEST(VolumeConfigTest, AVolumeWithoutContentIsAnError) {
  EXPECT_THAT(message_with({"volume.max_mm=[150, -150, 600]"}),
              HasSubstr("permitted is more than min_mm on each axis"));
  EXPECT_EQ(message_with({"volume.max_mm=[150, -149.999, 600]"}), "");
}

const std::vector<std::string> kDatum{"datum.position_mm=[-180, 120, 650.5]", "datum.uncertainty_mm=0.2",
                                      "datum.radius_mm=10"};

std::string message_with_datum_and(const std::string& override) {
  std::vector<std::string> overrides = kDatum;
  overrides.push_back(override);
  return message_with(overrides);
}

TEST(DatumConfigTest, EveryKeyIsRead) {
  EXPECT_FALSE(config_with({})->datum);
  const DatumConfig datum = config_with(kDatum)->datum.value();
  EXPECT_EQ(datum.position_mm, Vec3(-180.0, 120.0, 650.5));
  EXPECT_EQ(datum.uncertainty_mm, 0.2);
  EXPECT_EQ(datum.radius_mm, 10.0);
}

TEST(DatumConfigTest, EachKeyIsRequiredAndSaysItsLine) {
  const std::string text = std::string{testing::kSmallest} + "[datum]\n";
  EXPECT_EQ(testing::message_of(text),
            "demo.toml:6: datum.position_mm is missing: permitted is 3 numbers from -100000 "
            "to 100000");
  EXPECT_THAT(testing::message_of(text + "position_mm = [0, 0, 700]\n"), HasSubstr("datum.uncertainty_mm is missing"));
  EXPECT_THAT(testing::message_of(text + "position_mm = [0, 0, 700]\nuncertainty_mm = 0.2\n"),
              HasSubstr("datum.radius_mm is missing"));
  EXPECT_THAT(testing::message_of(text + "position_mm = [0, 0, 700]\nradius = 10\n"),
              HasSubstr("demo.toml:8: unknown key datum.radius"));
}

TEST(DatumConfigTest, WhatNoDatumHasIsRefused) {
  EXPECT_THAT(message_with_datum_and("datum.position_mm=[nan, 0, 700]"), HasSubstr("permitted is 3 numbers"));
  EXPECT_THAT(message_with_datum_and("datum.position_mm=[0, 700]"), HasSubstr("permitted is 3 numbers"));
  EXPECT_THAT(message_with_datum_and("datum.uncertainty_mm=0"), HasSubstr("from 0.001 to 100"));
  EXPECT_THAT(message_with_datum_and("datum.radius_mm=inf"), HasSubstr("from 0.1 to 1000"));
  EXPECT_THAT(message_with_datum_and("datum.radius_mm=1.19"), HasSubstr("permitted is six times uncertainty_mm"));
  EXPECT_EQ(message_with_datum_and("datum.radius_mm=1.2"), "");
}

TEST(DatumConfigTest, ItIsAnLedThatIsLitAllTheTime) {
  EXPECT_THAT(message_with_datum_and("detector.kind=apriltag"), HasSubstr("permitted is [datum] with \"led\""));
  EXPECT_THAT(message_with_datum_and("modulation.enabled=true"),
              HasSubstr("permitted is [datum] with modulation.enabled = false"));
}

TEST(TimingConfigTest, EveryKeyHasItsRange) {
  const TimingConfig t =
      config_with({"timing.offset_prior_ms=0.1", "timing.bound_mm=0.5", "timing.line_time_us=30"})->timing;
  EXPECT_EQ(t.offset_prior_ms, 0.1);
  EXPECT_EQ(t.bound_mm, 0.5);
  EXPECT_EQ(t.line_time_us, 30.0);
  EXPECT_THAT(message_with({"timing.offset_prior_ms=0"}), HasSubstr("from 0.001 to 1000"));
}

TEST(OutputConfigTest, EveryKeyIsRead) {
  const OutputConfig o = config_with({"output.frame=left_camera", "output.method=paper", "output.age_limit_ms=150",
                                      "output.latch_hold_ms=5000", "output.settled_mm_per_s=2"})
                             ->output;
  EXPECT_EQ(o.frame, ConfiguredFrame::kLeftCamera);
  EXPECT_EQ(o.method, ConfiguredMethod::kPaper);
  EXPECT_EQ(o.age_limit, std::chrono::milliseconds{150});
  EXPECT_EQ(o.latch_hold, std::chrono::milliseconds{5000});
  EXPECT_EQ(o.settled_mm_per_s, 2.0);
}

TEST(OutputConfigTest, TheRobotsFrameNeedsARegistrationThatDoesNotExist) {
  EXPECT_THAT(message_with({"output.frame=robot_base"}), HasSubstr("permitted is \"reference\" or \"left_camera\""));
}

TEST(ModbusConfigTest, EveryKeyIsRead) {
  const ModbusConfig m = config_with({"modbus.address=0.0.0.0", "modbus.port=502",
                                      "modbus.command_clients=[\"127.0.0.1\", \"10.0.0.0/8\"]",
                                      "modbus.allowed_clients=[\"192.168.1.0/24\"]", "modbus.max_connections=8",
                                      "modbus.serial_number=4294967295"})
                             ->modbus;
  EXPECT_EQ(m.address, "0.0.0.0");
  EXPECT_EQ(m.port, 502);
  EXPECT_THAT(m.command_clients, ElementsAre("127.0.0.1", "10.0.0.0/8"));
  EXPECT_THAT(m.allowed_clients, ElementsAre("192.168.1.0/24"));
  EXPECT_EQ(m.max_connections, 8);
  EXPECT_EQ(m.serial_number, 4'294'967'295U);
}

TEST(ModbusConfigTest, WhatIsNoAddressIsAnError) {
  EXPECT_THAT(message_with({"modbus.address=localhost"}), HasSubstr("numeric address"));
  EXPECT_THAT(message_with({"modbus.command_clients=[\"10.0.0.0/33\"]"}), HasSubstr("numeric addresses or networks"));
  EXPECT_THAT(message_with({"modbus.allowed_clients=[\"plc\"]"}), HasSubstr("numeric addresses or networks"));
}

}  // namespace
}  // namespace tripoint
