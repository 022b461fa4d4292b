#include "app/camera_pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <tuple>
#include <variant>
#include <vector>

namespace tripoint {
namespace {

using std::chrono::microseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr ImageSize kSize{16, 8};
constexpr ExposureSetting kWanted{microseconds{1500}, 7};

/// A picture with this luma everywhere, a damaged MJPEG, or an error.
struct Damaged {};
using Shown = std::variant<std::uint8_t, Damaged, Error>;

/// Shows what a test says, and then nothing any more.
class ShowingCamera final : public Camera {
 public:
  ShowingCamera(CameraInfo info, std::deque<Shown> shown) : info_(std::move(info)), shown_(std::move(shown)) {}

  Result<Frame> next_frame(Duration) override {
    if (shown_.empty()) return failure(ErrorCode::kTimeout, "nothing came");
    const Shown now = shown_.front();
    shown_.pop_front();
    if (const auto* error = std::get_if<Error>(&now)) return tl::make_unexpected(*error);
    const auto* luma = std::get_if<std::uint8_t>(&now);
    bytes_.assign(std::size_t{2} * kSize.width_px * kSize.height_px, luma != nullptr ? *luma : 0);
    return Frame{.format = luma != nullptr ? PixelFormat::kYuyv : PixelFormat::kMjpeg,
                 .size = kSize,
                 .stride_bytes = luma != nullptr ? std::size_t{2} * kSize.width_px : 0,
                 .data = bytes_,
                 .exposed = time_from_ns(luma != nullptr ? *luma : 0)};
  }
  [[nodiscard]] const CameraInfo& info() const override { return info_; }

 private:
  CameraInfo info_;
  std::deque<Shown> shown_;
  std::vector<std::uint8_t> bytes_;
};

CameraInfo usual_info() {
  CameraInfo info;
  info.exposure = microseconds{1500};
  info.shortest_exposure = microseconds{100};
  info.longest_exposure = microseconds{20'000};
  info.gain = 7;
  info.gains = GainRange{0, 255, 1};
  return info;
}

class CameraPairTest : public testing::Test {
 protected:
  Result<CameraPair> open() {
    return CameraPair::open(
        config_,
        [this](const Config& config) -> Result<PerSide<OpenCamera>> {
          asked_ = config.cameras.measuring;
          return PerSide<OpenCamera>{[this] { return camera(Side::kLeft); }, [this] { return camera(Side::kRight); }};
        },
        kWanted);
  }
  Error refusal() {
    const Result<CameraPair> cameras = open();
    EXPECT_FALSE(cameras);
    return cameras ? Error{ErrorCode::kMalformed} : cameras.error();
  }
  /// The luma of what the right camera shows when asked for so many pictures.
  Result<std::vector<int>> watched(int pictures) {
    std::vector<int> lumas;
    return open()
        .and_then([&](const CameraPair& cameras) {
          return cameras.watch(Side::kRight, pictures,
                               [&](const Picture& picture) { lumas.push_back(picture.luma.at(3, 2)); });
        })
        .map([&] { return lumas; });
  }

  /// Side, luma and time of what is shot, in the order of coming.
  Result<std::vector<std::tuple<Side, int, TimePoint>>> shot() {
    std::vector<std::tuple<Side, int, TimePoint>> shots;
    return open()
        .and_then([&](const CameraPair& cameras) {
          return cameras.shoot([&](Side side, const Picture& picture, TimePoint exposed) {
            shots.emplace_back(side, picture.luma.at(3, 2), exposed);
          });
        })
        .map([&] { return shots; });
  }

  Config config_;
  PerSide<CameraInfo> info_{usual_info(), usual_info()};
  PerSide<std::deque<Shown>> shown_;
  std::optional<Error> right_cannot_open_;
  std::optional<ExposureSetting> asked_;

 private:
  Result<std::unique_ptr<Camera>> camera(Side side) {
    if (side == Side::kRight && right_cannot_open_) return tl::make_unexpected(*right_cannot_open_);
    return std::make_unique<ShowingCamera>(info_[side], shown_[side]);
  }
};

TEST_F(CameraPairTest, CamerasAreOpenedWithTheWantedSetting) {
  config_.cameras.measuring = {microseconds{9000}, 1};
  ASSERT_TRUE(open());
  EXPECT_EQ(asked_, kWanted);
}

TEST_F(CameraPairTest, TheSettingIsWhatTheCamerasReadBack) {
  for (const Side side : kBothSides) info_[side].exposure = microseconds{1600};  // rounded
  for (const Side side : kBothSides) info_[side].gain = 8;
  EXPECT_EQ(open()->setting(), (ExposureSetting{microseconds{1600}, 8}));
}

TEST_F(CameraPairTest, CamerasWithoutGainKeepTheWantedOneAndOfferNoOther) {
  for (const Side side : kBothSides) info_[side].gain.reset();
  for (const Side side : kBothSides) info_[side].gains.reset();
  EXPECT_EQ(open()->setting(), kWanted);
  EXPECT_EQ(open()->offered().gains, (GainRange{7, 7, 1}));
}

TEST_F(CameraPairTest, CamerasThatReadBackDifferentlyAreRefused) {
  info_.right.exposure = microseconds{1600};
  EXPECT_EQ(refusal().code, ErrorCode::kMismatch);
  EXPECT_THAT(refusal().message, AllOf(HasSubstr("left 1500 us with gain 7"), HasSubstr("right 1600 us with gain 7")));
  info_ = {usual_info(), usual_info()};
  info_.left.gain = 8;
  EXPECT_EQ(refusal().code, ErrorCode::kMismatch);
}

TEST_F(CameraPairTest, ACameraThatCannotBeOpenedIsTheErrorItself) {
  for (const ErrorCode code : {ErrorCode::kDeviceMissing, ErrorCode::kDeviceBusy, ErrorCode::kControlRefused}) {
    right_cannot_open_ = Error{code, "right (usb 1-2): why"};
    EXPECT_EQ(refusal().code, code);
    EXPECT_EQ(refusal().message, "right (usb 1-2): why");
  }
}

TEST_F(CameraPairTest, OfferedIsWhatBothCamerasOffer) {
  info_.left.shortest_exposure = microseconds{200};
  info_.right.longest_exposure = microseconds{10'000};
  info_.left.gains = GainRange{16, 100, 4};
  info_.right.gains = GainRange{0, 255, 1};
  const ExposureOffer offered = open()->offered();
  EXPECT_EQ(offered.shortest, microseconds{200});
  EXPECT_EQ(offered.longest, microseconds{10'000});
  EXPECT_EQ(offered.gains, (GainRange{16, 100, 4}));
}

TEST_F(CameraPairTest, NoExposureIsLongerThanAFrame) {
  config_.cameras.rate_hz = 100.0;
  EXPECT_EQ(open()->offered().longest, microseconds{10'000});
  for (const Side side : kBothSides) info_[side].longest_exposure = Duration{0};  // not known
  EXPECT_EQ(open()->offered().longest, microseconds{10'000});
}

TEST_F(CameraPairTest, PicturesThatMayStillHaveTheOldSettingAreNotShown) {
  shown_.right = {std::uint8_t{1},  std::uint8_t{2},  std::uint8_t{3},
                  std::uint8_t{50}, std::uint8_t{60}, std::uint8_t{70}};
  EXPECT_THAT(watched(2).value(), ElementsAre(50, 60));
}

TEST_F(CameraPairTest, DamagedPicturesAreLeftOut) {
  shown_.right = {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{50}, std::uint8_t{60}};
  shown_.right.insert(shown_.right.begin() + 4, 5, Shown(Damaged{}));
  shown_.right.insert(shown_.right.begin() + 4, 5, Shown(Error{ErrorCode::kCorruptFrame, "truncated"}));
  EXPECT_THAT(watched(2).value(), ElementsAre(50, 60));
}

TEST_F(CameraPairTest, ACameraWithNothingButDamagedPicturesIsBroken) {
  shown_.right.assign(11, Shown(Damaged{}));
  shown_.right.insert(shown_.right.end(), 5, Shown(std::uint8_t{50}));
  const Result<std::vector<int>> pictures = watched(2);
  ASSERT_FALSE(pictures);
  EXPECT_EQ(pictures.error().code, ErrorCode::kDeviceMissing);
}

TEST_F(CameraPairTest, ACameraThatStopsIsNamed) {
  shown_.right = {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{50}};
  const Result<std::vector<int>> pictures = watched(2);
  ASSERT_FALSE(pictures);
  EXPECT_EQ(pictures.error().code, ErrorCode::kDeviceMissing);
  EXPECT_THAT(pictures.error().message, HasSubstr("camera right stopped in the middle, nothing was written"));
}

TEST_F(CameraPairTest, OneSettledPictureOfEachCameraIsShotWithItsTime) {
  shown_.left = {std::uint8_t{1}, std::uint8_t{2}, Damaged{}, std::uint8_t{3}, std::uint8_t{40}, std::uint8_t{41}};
  shown_.right = {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, Damaged{}, std::uint8_t{50}, std::uint8_t{51}};
  EXPECT_THAT(shot().value(), ElementsAre(std::tuple(Side::kLeft, 40, time_from_ns(40)),
                                          std::tuple(Side::kRight, 50, time_from_ns(50))));
}

TEST_F(CameraPairTest, NothingIsShotBeforeBothCamerasHaveSettled) {
  shown_.left = {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{40}};
  shown_.right = {std::uint8_t{1}, std::uint8_t{2}};
  const auto shots = shot();
  ASSERT_FALSE(shots);
  EXPECT_THAT(shots.error().message, HasSubstr("camera right stopped in the middle, nothing was written"));
}

}  // namespace
}  // namespace tripoint
