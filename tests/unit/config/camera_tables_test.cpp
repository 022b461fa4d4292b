#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config_text.h"

namespace tripoint {
namespace {

using testing::config_with;
using ::testing::HasSubstr;
using testing::kSmallest;
using testing::message_of;
using testing::message_with;

TEST(CamerasConfigTest, EveryKeyIsRead) {
  const CamerasConfig c =
      config_with({"cameras.source=v4l2", "cameras.format=mjpeg", "cameras.width_px=1280", "cameras.height_px=720",
                   "cameras.rate_hz=29.97", "cameras.exposure_us=500", "cameras.gain=3", "cameras.white_balance_k=5000",
                   "cameras.focus=10", "cameras.loss_after_ms=150", "cameras.left.port=1-1", "cameras.right.serial=R",
                   "cameras.right.device=/dev/video2"})
          ->cameras;
  EXPECT_EQ(c.source, CameraSource::kV4l2);
  EXPECT_EQ(c.format, ConfiguredFormat::kMjpeg);
  EXPECT_EQ(c.size, (ImageSize{1280, 720}));
  EXPECT_EQ(c.rate_hz, 29.97);
  EXPECT_EQ(c.measuring.exposure, std::chrono::microseconds{500});
  EXPECT_EQ(c.measuring.gain, 3);
  EXPECT_EQ(c.white_balance_k, 5000);
  EXPECT_EQ(c.focus, 10);
  EXPECT_EQ(c.loss_after, std::chrono::milliseconds{150});
  EXPECT_EQ(c.bindings.left.port, "1-1");
  EXPECT_EQ(c.bindings.right.serial, "R");
  EXPECT_EQ(c.bindings.right.device, "/dev/video2");
}

TEST(CamerasConfigTest, TheExposureForCalibratingIsAbsentOrWhole) {
  EXPECT_EQ(config_with({})->cameras.calibrating, std::nullopt);
  const Result<Config> both = config_with({"cameras.calibrating.exposure_us=9000", "cameras.calibrating.gain=7"});
  EXPECT_EQ(both->cameras.calibrating, (ExposureSetting{std::chrono::microseconds{9000}, 7}));
  EXPECT_EQ(both->cameras.measuring, ExposureSetting{});
  const Result<Config> without_gain = config_with({"cameras.calibrating.exposure_us=9000"});
  EXPECT_EQ(without_gain->cameras.calibrating, (ExposureSetting{std::chrono::microseconds{9000}, 0}));
  EXPECT_THAT(message_of(std::string(kSmallest) + "[cameras.calibrating]\ngain = 1\n"),
              HasSubstr("demo.toml:6: cameras.calibrating.exposure_us is missing: permitted is a whole number from 1"));
}

TEST(CamerasConfigTest, TheExposureForCalibratingHasTheRangesOfTheOneForMeasuring) {
  const std::string heading = std::string(kSmallest) + "[cameras.calibrating]\n";
  EXPECT_THAT(
      message_of(heading + "exposure_us = 0\n"),
      HasSubstr("demo.toml:7: cameras.calibrating.exposure_us = 0: permitted is a whole number from 1 to 1000000"));
  EXPECT_THAT(message_of(heading + "exposure_us = 1\ngain = 65536\n"),
              HasSubstr("demo.toml:8: cameras.calibrating.gain = 65536: permitted is a whole number from 0 to 65535"));
  EXPECT_THAT(message_of(heading + "exposure_us = 1\ngains = 6\n"),
              HasSubstr("demo.toml:8: unknown key cameras.calibrating.gains"));
  EXPECT_EQ(message_with({"cameras.rate_hz=50", "cameras.calibrating.exposure_us=20000"}), "");
  EXPECT_THAT(
      message_with({"cameras.rate_hz=50", "cameras.calibrating.exposure_us=20001"}),
      HasSubstr("cameras.calibrating.exposure_us = 20001: longer than a frame: permitted at 50 Hz is up to 20000"));
}

TEST(CamerasConfigTest, OnlyThreeSizesArePermitted) {
  EXPECT_EQ(message_with({"cameras.width_px=320", "cameras.height_px=240"}), "");
  EXPECT_THAT(message_with({"cameras.width_px=320"}), HasSubstr("permitted is 320 x 240, 640 x 480 or 1280 x 720"));
  EXPECT_THAT(message_with({"cameras.width_px=800", "cameras.height_px=600"}), HasSubstr("permitted"));
}

TEST(CamerasConfigTest, AnUnknownSourceOrFormatListsThePermittedOnes) {
  EXPECT_THAT(message_with({"cameras.source=usb"}), HasSubstr("\"v4l2\", \"simulation\" or \"recording\""));
  EXPECT_THAT(message_with({"cameras.format=rgb"}), HasSubstr("\"yuyv\", \"mjpeg\" or \"grey\""));
}

TEST(CamerasConfigTest, RealCamerasMustBeToldApart) {
  EXPECT_THAT(message_with({"cameras.source=v4l2", "cameras.left.port=1-1"}),
              HasSubstr("cameras.right: names no camera"));
  EXPECT_EQ(message_with({"cameras.source=v4l2", "cameras.left.port=1-1", "cameras.right.serial=R"}), "");
}

TEST(CamerasConfigTest, TheExposureFitsIntoAFrame) {
  EXPECT_EQ(message_with({"cameras.rate_hz=25", "cameras.exposure_us=40000"}), "");
  EXPECT_THAT(message_with({"cameras.rate_hz=25", "cameras.exposure_us=40001"}), HasSubstr("up to 40000"));
}

TEST(CamerasConfigTest, LossIsNotSaidBeforeTheNextFrameCanCome) {
  EXPECT_EQ(message_with({"cameras.rate_hz=30", "cameras.loss_after_ms=50"}), "");
  EXPECT_THAT(message_with({"cameras.rate_hz=30", "cameras.loss_after_ms=49"}), HasSubstr("from 50 to 10000"));
}

TEST(DetectorConfigTest, LedsOnGreyAreAnErrorThatSaysWhy) {
  EXPECT_THAT(message_with({"cameras.format=grey"}),
              HasSubstr("cameras.format = grey: red LEDs and spheres cannot be told from other things without colour"));
}

TEST(DetectorConfigTest, TheLimitsOfADetectorAreRanges) {
  EXPECT_EQ(config_with({"detector.min_peak=900", "detector.min_contrast=50"})->detector.min_peak, 900);
  EXPECT_EQ(config_with({"detector.min_emission=-0.1"})->detector.min_emission, -0.1);
  EXPECT_FALSE(config_with({"detector.min_emission=-0.3"}).has_value());
  EXPECT_THAT(message_with({"detector.kind=aruco"}), HasSubstr("\"led\", \"sphere\" or \"apriltag\""));
}

TEST(DetectorConfigTest, TheLimitsOfSpheresAreRanges) {
  const auto config = config_with({"detector.kind=sphere", "detector.min_radius_px=20", "detector.max_radius_px=70",
                                   "detector.min_redness=0.5", "detector.min_fill=0.6"});
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_EQ(config->detector.kind, ConfiguredDetector::kSphere);
  EXPECT_EQ(config->detector.min_radius_px, 20.0);
  EXPECT_EQ(config->detector.max_radius_px, 70.0);
  EXPECT_EQ(config->detector.min_redness, 0.5);
  EXPECT_EQ(config->detector.min_fill, 0.6);
  for (const char* wrong : {"detector.min_radius_px=7", "detector.max_radius_px=401", "detector.min_redness=0.05",
                            "detector.min_fill=0.96"}) {
    EXPECT_FALSE(config_with({"detector.kind=sphere", wrong})) << wrong;
  }
}

TEST(DetectorConfigTest, TheSmallestSphereIsNotAboveTheLargest) {
  EXPECT_EQ(message_with({"detector.kind=sphere", "detector.min_radius_px=50", "detector.max_radius_px=50"}), "");
  EXPECT_THAT(message_with({"detector.kind=sphere", "detector.min_radius_px=50", "detector.max_radius_px=49"}),
              HasSubstr("permitted is from 50"));
}

TEST(DetectorConfigTest, KeysOfTheOtherDetectorAreUnknown) {
  EXPECT_THAT(message_with({"detector.min_fill=0.5"}), HasSubstr("detector.min_fill"));
  EXPECT_THAT(message_with({"detector.kind=sphere", "detector.min_peak=900"}), HasSubstr("detector.min_peak"));
  EXPECT_THAT(message_with({"detector.min_margin=30"}), HasSubstr("detector.min_margin"));
  EXPECT_THAT(message_with({"detector.kind=apriltag", "detector.min_fill=0.5"}), HasSubstr("detector.min_fill"));
}

TEST(DetectorConfigTest, SpheresOnGreyAreAnErrorAsWell) {
  EXPECT_THAT(message_with({"cameras.format=grey", "detector.kind=sphere"}), HasSubstr("without colour"));
}

TEST(DetectorConfigTest, TagsNeedNoColour) {
  const auto config = config_with({"cameras.format=grey", "detector.kind=apriltag", "detector.min_margin=30"});
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_EQ(config->detector.kind, ConfiguredDetector::kAprilTag);
  EXPECT_EQ(config->detector.min_margin, 30.0);
  EXPECT_FALSE(config_with({"detector.kind=apriltag", "detector.min_margin=256"}));
}

TEST(SimulationConfigTest, EveryKeyIsRead) {
  const SimulationConfig s = config_with({"simulation.scenario=scout", "simulation.trajectory_file=t.csv",
                                          "simulation.seed=7", "simulation.stamp_jitter_us=3000",
                                          "simulation.clock_drift_ppm=-50", "simulation.right_phase_ms=12.5"})
                                 ->simulation;
  EXPECT_EQ(s.scenario, Scenario::kScout);
  EXPECT_EQ(s.trajectory_file, "/etc/tripoint/t.csv");
  EXPECT_EQ(s.seed, 7U);
  EXPECT_EQ(s.stamp_jitter_us, 3000.0);
  EXPECT_EQ(s.clock_drift_ppm, -50.0);
  EXPECT_EQ(s.right_phase_ms, 12.5);
}

TEST(SimulationConfigTest, AnUnknownScenarioListsTheShippedOnes) {
  EXPECT_THAT(message_with({"simulation.scenario=clutter"}),
              HasSubstr("\"paper-linear\", \"paper-circular\", \"scout\", \"static-volume\" or \"bumped-camera\""));
}

TEST(RecordingConfigTest, ARecordingAsSourceNeedsItsFolder) {
  EXPECT_THAT(message_with({"cameras.source=recording"}), HasSubstr("recording.folder: missing"));
  const Config c = config_with({"cameras.source=recording", "recording.folder=r"}).value();
  EXPECT_EQ(c.recording.folder, "/etc/tripoint/r");
}

}  // namespace
}  // namespace tripoint
