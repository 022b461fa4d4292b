// `tripointd expose` before cameras that a test makes brighter or darker between two looks.
#include "app/expose_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "places.h"
#include "ports/camera.h"
#include "scratch_folder.h"
#include "sim/renderer.h"
#include "sim/settings.h"
#include "sim/world.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kWell = 0;
constexpr int kNothingSuits = 1;  // docs/reference/tripointd.md
constexpr double kNear_mm = 360.0;
constexpr double kFar_mm = 400.0;
constexpr int kLooksUntilCheck = 2;  // at the far end: with what suits the near end, and with what it tells
constexpr double kPeakPer_us = 1.5 / 2000.0;

/// Shows the same rendered picture again and again.
class StillCamera final : public Camera {
 public:
  StillCamera(CameraInfo info, RenderedFrame shown) : info_(std::move(info)), shown_(std::move(shown)) {}

  Result<Frame> next_frame(Duration) override { return frame_of(shown_); }
  [[nodiscard]] const CameraInfo& info() const override { return info_; }

 private:
  CameraInfo info_;
  RenderedFrame shown_;
};

/// An LED held at this depth, as bright as the exposure and `light` make it.
SimulatedWorld world_showing_led(double z_mm, const ExposureSetting& setting, double light) {
  SimulationSettings settings;
  const auto exposure_us = static_cast<double>(setting.exposure.count());
  settings.scene = led_scene({Vec3::Zero()}, light * kPeakPer_us * exposure_us);
  settings.scene.white_level = 0.0;
  settings.trajectory.reference_from_target = [z_mm](double /*second*/) {
    Isometry3 pose = Isometry3::Identity();
    pose.translation() = Vec3(0.0, 0.0, z_mm);
    return pose;
  };
  return SimulatedWorld::create(settings).value();
}

class ExposeCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"demo.toml", "calibration.toml", "target.toml"}) {
      fs::copy_file(test::top_folder() / "deploy/demo" / name, folder_ / name, fs::copy_options::overwrite_existing);
    }
    const Result<Config> config = load_config(file(), {});
    ASSERT_TRUE(config) << config.error().message;
    config_ = *config;
    config_.volume.min_mm.z() = kNear_mm;
    config_.volume.max_mm.z() = kFar_mm;
  }

  [[nodiscard]] fs::path file() const { return folder_ / "demo.toml"; }
  [[nodiscard]] std::string file_text() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The exit code, when the LED has this light in the check.
  int exposed_with_light_at_check(double light_at_check) {
    const ExposeOptions options{.config = file(), .overrides = {}, .write = true};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = expose_for_measuring(
        options, config_, 1, [&](const Config& wanted, double z_mm) -> Result<PerSide<OpenCamera>> {
          looks_at_far_end_ += z_mm == kFar_mm ? 1 : 0;
          const double light = looks_at_far_end_ > kLooksUntilCheck ? light_at_check : 1.0;
          const ExposureSetting setting = wanted.cameras.measuring;
          const auto open = [=](Side side) {
            return [=]() -> Result<std::unique_ptr<Camera>> {
              CameraInfo info;
              info.exposure = setting.exposure;
              return std::make_unique<StillCamera>(info,
                                                   render(world_showing_led(z_mm, setting, light), side, Duration{0}));
            };
          };
          return PerSide<OpenCamera>{open(Side::kLeft), open(Side::kRight)};
        });
    stdout_ = testing::internal::GetCapturedStdout();
    stderr_ = testing::internal::GetCapturedStderr();
    return code;
  }

  Config config_;
  int looks_at_far_end_ = 0;
  std::string stdout_;
  std::string stderr_;

 private:
  test::ScratchFolder folder_;
};

TEST_F(ExposeCommandTest, WhatTheCheckConfirmsIsWritten) {
  const std::string before = file_text();
  EXPECT_EQ(exposed_with_light_at_check(1.0), kWell) << stderr_;
  EXPECT_EQ(looks_at_far_end_, kLooksUntilCheck + 1) << stdout_;
  EXPECT_NE(file_text(), before);
}

TEST_F(ExposeCommandTest, AnLedThatIsDarkerInTheCheckIsAskedAboutAndNothingIsWritten) {
  const std::string before = file_text();
  EXPECT_EQ(exposed_with_light_at_check(0.25), kNothingSuits);
  EXPECT_EQ(looks_at_far_end_, kLooksUntilCheck + 1) << stdout_;
  EXPECT_THAT(stderr_, HasSubstr("checked in a fresh picture"));
  EXPECT_THAT(stderr_, HasSubstr("was the target moved?"));
  EXPECT_EQ(file_text(), before);
}

TEST_F(ExposeCommandTest, AnLedThatIsGoneInTheCheckIsAskedAboutAndNothingIsWritten) {
  const std::string before = file_text();
  EXPECT_EQ(exposed_with_light_at_check(0.0), kNothingSuits);
  EXPECT_THAT(stderr_, HasSubstr("left 0 spots, right 0 spots; was the target moved?"));
  EXPECT_EQ(file_text(), before);
}

}  // namespace
}  // namespace tripoint
