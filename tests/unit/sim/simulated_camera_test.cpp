#include "sim/simulated_camera.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

using std::chrono::milliseconds;

constexpr TimePoint kStart = time_from_ns(100'000'000'000);
constexpr Duration kUtcOffset{std::chrono::seconds{1'000'000}};

/// Stands still unless it is set.
class HandClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  [[nodiscard]] Duration utc_offset() const override { return kUtcOffset; }
  [[nodiscard]] bool synchronised() const override { return true; }
  void set(TimePoint now) { now_ = std::max(now_, now); }

 private:
  TimePoint now_ = kStart;
};

SimulationSettings camera_settings() {
  SimulationSettings settings = bare_settings();
  settings.rate_hz = 50.0;  // 20 ms
  settings.line_time = std::chrono::microseconds{20};
  settings.exposure = milliseconds{2};
  return settings;
}
constexpr Duration kReadout = std::chrono::microseconds{1000 + 479 * 20};

/// A camera on a clock that jumps to wherever the camera waits for.
class SimulatedCameraTest : public testing::Test {
 protected:
  void build(const SimulationSettings& settings, Side side = Side::kLeft) {
    world_ = std::make_unique<SimulatedWorld>(world_of(settings, kStart));
    auto opened = SimulatedCamera::open(*world_, side, clock_, [this](TimePoint until) { clock_.set(until); });
    ASSERT_TRUE(opened) << opened.error().message;
    camera_ = *std::move(opened);
  }
  ErrorCode refusal(Duration limit) {
    const Result<Frame> frame = camera_->next_frame(limit);
    EXPECT_FALSE(frame);
    return frame ? ErrorCode::kMalformed : frame.error().code;
  }

  HandClock clock_;
  std::unique_ptr<SimulatedWorld> world_;
  std::unique_ptr<SimulatedCamera> camera_;
};

TEST_F(SimulatedCameraTest, FramesArriveInOrderWhenReadOut) {
  build(camera_settings());
  for (std::uint32_t i = 0; i < 5; ++i) {
    const Result<Frame> frame = camera_->next_frame(milliseconds{100});
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_EQ(frame->sequence, i);
    EXPECT_EQ(frame->exposed, kStart + i * milliseconds{20});
    EXPECT_EQ(frame->arrived, frame->exposed + kReadout);
    EXPECT_EQ(frame->data.size(), 640U * 480U * 2U);
    EXPECT_EQ(frame->line_time, std::chrono::microseconds{20});
    EXPECT_EQ(picture_of(*frame).size, camera_->info().size);
  }
}

TEST_F(SimulatedCameraTest, LateConsumerGetsTheNewestFrameAndAGap) {
  build(camera_settings());
  ASSERT_TRUE(camera_->next_frame(milliseconds{100}));
  clock_.set(kStart + milliseconds{130});  // frame 5 was ready at 110.58 ms, frame 6 comes at 130.58
  const Result<Frame> frame = camera_->next_frame(milliseconds{100});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 5U);
  EXPECT_EQ(frame->exposed, kStart + milliseconds{100});
  EXPECT_EQ(camera_->next_frame(milliseconds{100})->sequence, 6U);
}

TEST_F(SimulatedCameraTest, LimitIsKept) {
  build(camera_settings());
  EXPECT_EQ(refusal(milliseconds{5}), ErrorCode::kTimeout);
  EXPECT_EQ(clock_.now(), kStart + milliseconds{5});
  EXPECT_EQ(refusal(Duration{0}), ErrorCode::kTimeout);
  ASSERT_TRUE(camera_->next_frame(milliseconds{10}));
}

TEST_F(SimulatedCameraTest, TargetIsWhereUtcSaysAndStampsAreWhatTheClockSays) {
  SimulationSettings settings = camera_settings();
  settings.trajectory = paper_circular();
  settings.clocks.right = {.phase = milliseconds{7}, .stamp_jitter = milliseconds{3}};
  build(settings, Side::kRight);
  for (int i = 0; i < 3; ++i) {
    const Result<Frame> frame = camera_->next_frame(milliseconds{100});
    ASSERT_TRUE(frame);
    const FrameTruth& truth = camera_->truth();
    EXPECT_EQ(truth.exposed, kStart + milliseconds{7} + i * milliseconds{20});
    EXPECT_EQ(truth.exposed_since_1970, truth.exposed.time_since_epoch() + kUtcOffset);
    const Isometry3 expected = target_pose_at(paper_circular(), truth.exposed_since_1970);
    EXPECT_TRUE(truth.reference_from_target.isApprox(expected));
    EXPECT_EQ(frame->exposed, truth.stamp);
    EXPECT_NE(truth.stamp, truth.exposed);
    EXPECT_LT(std::abs(seconds(truth.stamp - truth.exposed)), 0.012);  // cut at four sigma
  }
}

TEST_F(SimulatedCameraTest, LinesAreAskedOnlyAboutTimesThatAreOver) {
  SimulationSettings settings = camera_settings();
  Duration latest{0};
  settings.lit_share = [&](std::size_t, Duration, Duration to_1970) {
    latest = std::max(latest, to_1970);
    EXPECT_LE(to_1970, clock_.now().time_since_epoch() + kUtcOffset);
    return 1.0;
  };
  build(settings);
  ASSERT_TRUE(camera_->next_frame(milliseconds{100}));
  EXPECT_GT(latest, Duration{0}) << "it was asked";
}

TEST_F(SimulatedCameraTest, CameraOpenedLaterStartsCountingFromZero) {
  clock_.set(kStart + std::chrono::seconds{10});
  build(camera_settings());
  const Result<Frame> frame = camera_->next_frame(milliseconds{100});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 0U);
  EXPECT_EQ(frame->exposed, kStart + std::chrono::seconds{10});
}

TEST_F(SimulatedCameraTest, VanishedCameraStaysLostUntilOpenedAnewAfterwards) {
  SimulationSettings settings = camera_settings();
  settings.troubles = {
      {.side = Side::kLeft, .trouble = Trouble::kVanish, .from = milliseconds{50}, .to = milliseconds{200}}};
  build(settings);
  ASSERT_TRUE(camera_->next_frame(milliseconds{100}));
  ASSERT_TRUE(camera_->next_frame(milliseconds{100}));
  EXPECT_EQ(refusal(milliseconds{100}), ErrorCode::kDeviceMissing);
  clock_.set(kStart + milliseconds{60});
  const auto reopened = SimulatedCamera::open(*world_, Side::kLeft, clock_, [](TimePoint) {});
  ASSERT_FALSE(reopened);
  EXPECT_EQ(reopened.error().code, ErrorCode::kDeviceMissing);
  EXPECT_TRUE(SimulatedCamera::open(*world_, Side::kRight, clock_, [](TimePoint) {}));
  clock_.set(kStart + milliseconds{300});
  EXPECT_EQ(refusal(milliseconds{100}), ErrorCode::kDeviceMissing);
  build(settings);
  EXPECT_TRUE(camera_->next_frame(milliseconds{100}));
}

TEST_F(SimulatedCameraTest, HungCameraGivesNothingAndComesBack) {
  SimulationSettings settings = camera_settings();
  settings.troubles = {
      {.side = Side::kLeft, .trouble = Trouble::kHang, .from = milliseconds{25}, .to = milliseconds{200}}};
  build(settings);
  ASSERT_TRUE(camera_->next_frame(milliseconds{100}));
  EXPECT_EQ(refusal(milliseconds{100}), ErrorCode::kTimeout);
  const Result<Frame> frame = camera_->next_frame(milliseconds{150});
  ASSERT_TRUE(frame);
  EXPECT_GE(frame->arrived, kStart + milliseconds{200});
  EXPECT_EQ(frame->sequence, 10U);  // ready at 210.58 ms
}

TEST_F(SimulatedCameraTest, RepeatedPictureHasFreshStamps) {
  SimulationSettings settings = camera_settings();
  settings.sensor = SensorModel{};  // noise: pictures differ by themselves
  settings.troubles = {
      {.side = Side::kLeft, .trouble = Trouble::kRepeat, .from = milliseconds{25}, .to = milliseconds{60}}};
  build(settings);
  std::vector<std::vector<std::uint8_t>> pictures;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Result<Frame> frame = camera_->next_frame(milliseconds{100});
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->sequence, i);
    EXPECT_EQ(frame->exposed, kStart + i * milliseconds{20});
    pictures.emplace_back(frame->data.begin(), frame->data.end());
  }
  EXPECT_EQ(pictures[1], pictures[0]);
  EXPECT_EQ(pictures[2], pictures[0]);
  EXPECT_NE(pictures[3], pictures[0]);
}

TEST_F(SimulatedCameraTest, CorruptMjpegIsCutOff) {
  SimulationSettings settings = camera_settings();
  settings.format = PixelFormat::kMjpeg;
  settings.troubles = {
      {.side = Side::kLeft, .trouble = Trouble::kCorrupt, .from = milliseconds{25}, .to = milliseconds{45}}};
  build(settings);
  const std::size_t whole = camera_->next_frame(milliseconds{100})->data.size();
  const Result<Frame> cut = camera_->next_frame(milliseconds{100});
  ASSERT_TRUE(cut);
  EXPECT_LT(cut->data.size(), whole * 2 / 3);
  EXPECT_EQ(cut->data[0], 0xFF);
  EXPECT_GT(camera_->next_frame(milliseconds{100})->data.size(), whole * 2 / 3);
}

TEST_F(SimulatedCameraTest, CorruptYuyvIsReported) {
  SimulationSettings settings = camera_settings();
  settings.troubles = {
      {.side = Side::kLeft, .trouble = Trouble::kCorrupt, .from = Duration{0}, .to = milliseconds{25}}};
  build(settings);
  EXPECT_EQ(refusal(milliseconds{100}), ErrorCode::kCorruptFrame);
  EXPECT_TRUE(camera_->next_frame(milliseconds{100}));
}

TEST_F(SimulatedCameraTest, InfoTellsTheGainAndTheGainsThatCommonWebcamsHave) {
  SimulationSettings settings = camera_settings();
  settings.gain = 33;
  build(settings);
  EXPECT_EQ(camera_->info().gain, 33);
  EXPECT_EQ(camera_->info().gains, (GainRange{0, 255, 1}));
}

TEST_F(SimulatedCameraTest, InfoSaysThatItIsSimulated) {
  build(camera_settings(), Side::kRight);
  EXPECT_EQ(camera_->info().serial, "SIM-RIGHT");
  EXPECT_EQ(camera_->info().rate_hz, 50.0);
  EXPECT_NE(camera_->info().name.find("simulated"), std::string::npos);
}

}  // namespace
}  // namespace tripoint
