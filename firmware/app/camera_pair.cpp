#include "app/camera_pair.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "capture/mjpeg_decoder.h"

namespace tripoint {
namespace {

using std::chrono::microseconds;

constexpr int kSettling = 3;                    ///< pictures until a new setting shows for certain
constexpr int kMostBadFrames = 10;              ///< damaged ones, before the camera counts as broken
constexpr Duration kFrameLimit{2'000'000'000};  ///< sensors start slowly

/// A camera without a gain control has none to read back.
ExposureSetting setting_of(const CameraInfo& info, const ExposureSetting& wanted) {
  return {std::chrono::duration_cast<microseconds>(info.exposure), info.gain.value_or(wanted.gain)};
}

Result<ExposureSetting> common_setting(const PerSide<std::unique_ptr<Camera>>& cameras, const ExposureSetting& wanted) {
  const ExposureSetting left = setting_of(cameras.left->info(), wanted);
  const ExposureSetting right = setting_of(cameras.right->info(), wanted);
  if (left == right) return left;
  return failure(
      ErrorCode::kMismatch,
      fmt::format("the cameras read back different settings for {} us with gain {}: left {} us with gain {}, "
                  "right {} us with gain {}; use two cameras of one kind",
                  wanted.exposure.count(), wanted.gain, left.exposure.count(), left.gain, right.exposure.count(),
                  right.gain));
}

Error stopped(Side side, const Error& error) {
  return {ErrorCode::kDeviceMissing,
          fmt::format("camera {} stopped in the middle, nothing was written; plug it in again, and start anew ({})",
                      name(side), error.message)};
}

}  // namespace

Result<CameraPair> CameraPair::open(Config config, const SupplyCameras& supply, const ExposureSetting& setting) {
  config.cameras.measuring = setting;
  Result<PerSide<OpenCamera>> openers = supply(config);
  if (!openers) return tl::make_unexpected(openers.error());
  PerSide<std::unique_ptr<Camera>> cameras;
  for (const Side side : kBothSides) {
    Result<std::unique_ptr<Camera>> camera = (*openers)[side]();
    if (!camera) return tl::make_unexpected(camera.error());
    cameras[side] = std::move(*camera);
  }
  const Result<ExposureSetting> read_back = common_setting(cameras, setting);
  if (!read_back) return tl::make_unexpected(read_back.error());
  return CameraPair(std::move(*openers), std::move(cameras), config, *read_back);
}

ExposureOffer CameraPair::offered() const {
  ExposureOffer offer{microseconds{1}, microseconds{static_cast<std::int64_t>(1e6 / rate_hz_)},
                      GainRange{0, 65'535, 1}};
  for (const Side side : kBothSides) {
    const CameraInfo& info = cameras_[side]->info();
    offer.shortest = std::max(offer.shortest, std::chrono::duration_cast<microseconds>(info.shortest_exposure));
    if (info.longest_exposure > Duration{0}) {
      offer.longest = std::min(offer.longest, std::chrono::duration_cast<microseconds>(info.longest_exposure));
    }
    const GainRange gains = info.gains.value_or(GainRange{setting_.gain, setting_.gain, 1});
    offer.gains = {std::max(offer.gains.lowest, gains.lowest), std::min(offer.gains.highest, gains.highest),
                   std::max(offer.gains.step, gains.step)};
  }
  return offer;
}

Result<void> CameraPair::show(Side side, int pictures, const See& see) const {
  MjpegDecoder decoder;
  int bad = 0;
  for (int seen = 0; seen < pictures;) {
    const Result<void> shown = cameras_[side]->next_frame(kFrameLimit).and_then([&](const Frame& frame) {
      const Result<Picture> picture = frame.format == PixelFormat::kMjpeg ? decoder.decode(frame.data, frame.size)
                                                                          : Result<Picture>(picture_of(frame));
      return picture.map([&](const Picture& decoded) { see(decoded, frame.exposed); });
    });
    if (shown) {
      ++seen;
    } else if (shown.error().code != ErrorCode::kCorruptFrame || ++bad > kMostBadFrames) {
      return tl::make_unexpected(stopped(side, shown.error()));
    }
  }
  return {};
}

Result<void> CameraPair::watch(Side side, int pictures, const std::function<void(const Picture&)>& see) const {
  int settling = kSettling;
  return show(side, kSettling + pictures, [&](const Picture& picture, TimePoint /*exposed*/) {
    if (settling-- <= 0) see(picture);
  });
}

Result<void> CameraPair::shoot(
    const std::function<void(Side side, const Picture& picture, TimePoint exposed)>& see) const {
  for (const Side side : kBothSides) {
    const Result<void> settled = show(side, kSettling, [](const Picture& /*picture*/, TimePoint /*exposed*/) {});
    if (!settled) return settled;
  }
  for (const Side side : kBothSides) {
    const Result<void> shown =
        show(side, 1, [&](const Picture& picture, TimePoint exposed) { see(side, picture, exposed); });
    if (!shown) return shown;
  }
  return {};
}

}  // namespace tripoint
