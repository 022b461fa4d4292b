#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config_text.h"

namespace tripoint {
namespace {

using testing::config_with;
using ::testing::HasSubstr;
using testing::message_with;

TEST(ModulationConfigTest, IsOffUnlessAskedFor) {
  EXPECT_FALSE(config_with({})->modulation.enabled);
  EXPECT_EQ(config_with({})->modulation.stamp_error_ms, 3.0);
  EXPECT_EQ(config_with({})->simulation.red_lamps, 0);
}

TEST(ModulationConfigTest, EveryKeyIsRead) {
  const Config c =
      config_with({"modulation.enabled=true", "modulation.lines=simulated", "modulation.stamp_error_ms=1.5",
                   "simulation.red_lamps=4", "simulation.led_lines=stuck_out"})
          .value();
  EXPECT_TRUE(c.modulation.enabled);
  EXPECT_EQ(c.modulation.lines, ModulationLines::kSimulated);
  EXPECT_EQ(c.modulation.stamp_error_ms, 1.5);
  EXPECT_EQ(c.simulation.red_lamps, 4);
  EXPECT_EQ(c.simulation.led_lines, SimulatedLines::kStuckOut);
}

TEST(ModulationConfigTest, RealAndRecordedCamerasHaveNoLinesAndAreRefused) {
  EXPECT_THAT(message_with({"modulation.enabled=true", "cameras.source=v4l2", "cameras.left.port=1-1",
                            "cameras.right.port=1-2"}),
              HasSubstr("modulation.enabled = true: this version can only switch simulated lines: permitted with "
                        "cameras.source \"v4l2\" or \"recording\" is false"));
  EXPECT_THAT(message_with({"modulation.enabled=true", "cameras.source=recording", "recording.folder=r"}),
              HasSubstr("can only switch simulated lines"));
  EXPECT_THAT(message_with({"modulation.lines=gpio"}), HasSubstr("permitted is \"simulated\""));
}

TEST(ModulationConfigTest, SpheresCannotBeSwitched) {
  EXPECT_THAT(message_with({"modulation.enabled=true", "detector.kind=sphere"}),
              HasSubstr("permitted with a detector.kind other than \"led\" is false"));
}

TEST(ModulationConfigTest, GreyIsRefusedWithModulationToo) {
  EXPECT_THAT(message_with({"modulation.enabled=true", "cameras.format=grey"}), HasSubstr("cameras.format = grey"));
}

TEST(ModulationConfigTest, ASlowCameraSeesLitLedsTooSeldom) {
  EXPECT_EQ(message_with({"modulation.enabled=true", "cameras.rate_hz=30"}), "");
  EXPECT_THAT(message_with({"modulation.enabled=true", "cameras.rate_hz=29.9"}),
              HasSubstr("permitted is cameras.rate_hz from 30"));
}

TEST(ModulationConfigTest, ExposuresAndStampsMustLeaveTimeToSwitch) {
  // At 40 Hz half a period is 12.5 ms: half of what 2.5 ms of exposure leave is 5 ms.
  const std::vector<std::string> fast{"modulation.enabled=true", "cameras.rate_hz=40", "cameras.exposure_us=2500"};
  const auto with = [&](const char* key) {
    std::vector<std::string> all = fast;
    all.emplace_back(key);
    return message_with(all);
  };
  EXPECT_EQ(with("modulation.stamp_error_ms=4.99"), "");
  EXPECT_THAT(with("modulation.stamp_error_ms=5"),
              HasSubstr("modulation.stamp_error_ms = 5: no time is left to switch"));
  EXPECT_THAT(with("modulation.stamp_error_ms=5"), HasSubstr("is below 5.00"));
  EXPECT_THAT(with("cameras.exposure_us=12500"), HasSubstr("permitted is cameras.exposure_us below 12500"));
}

TEST(ModulationConfigTest, NothingIsCheckedWhileItIsOff) {
  EXPECT_EQ(message_with({"cameras.rate_hz=15", "cameras.exposure_us=60000", "modulation.stamp_error_ms=99"}), "");
  EXPECT_THAT(message_with({"modulation.stamp_error_ms=101"}), HasSubstr("permitted"));
}

TEST(ModulationConfigTest, LinesThatAreNotThereCannotBeStuck) {
  EXPECT_THAT(message_with({"simulation.led_lines=stuck_lit"}),
              HasSubstr("simulation.led_lines = stuck_lit: there are no lines without modulation.enabled = true"));
}

TEST(ModulationConfigTest, ItIsPartOfTheSetup) {
  const auto text = [](const char* setting) { return canonical_text(config_with({setting}).value(), kSetupTables); };
  EXPECT_NE(text("modulation.enabled=true"), text("modulation.enabled=false"));
}

}  // namespace
}  // namespace tripoint
