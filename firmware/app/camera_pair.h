// Both cameras opened in one setting, for looking at what they show.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "capture/camera_worker.h"
#include "config/config.h"

namespace tripoint {

/// How to open both cameras as a configuration says.
using SupplyCameras = std::function<Result<PerSide<OpenCamera>>(const Config& config)>;

/// What both cameras offer; exposures up to the frame period.
struct ExposureOffer {
  std::chrono::microseconds shortest{0};
  std::chrono::microseconds longest{0};
  GainRange gains;  ///< the one in use and no other without such a control
};

class CameraPair {
 public:
  /// Opens both anew.
  ///
  /// @param setting  instead of the configured one for measuring
  /// @return errors of opening (kDeviceMissing, kDeviceBusy, kControlRefused, ...); kMismatch when the cameras read
  ///   back different values
  static Result<CameraPair> open(Config config, const SupplyCameras& supply, const ExposureSetting& setting);

  /// As both read it back.
  [[nodiscard]] const ExposureSetting& setting() const { return setting_; }
  [[nodiscard]] ExposureOffer offered() const;

  /// Shows pictures of one camera in turn, after those in which a new setting may not show yet.
  ///
  /// @return kDeviceMissing, naming the camera, when it stops in the middle
  Result<void> watch(Side side, int pictures, const std::function<void(const Picture&)>& see) const;

  /// Shows one picture of the left and then one of the right camera, as soon after it as it has one, both after those
  /// in which a new setting may not show yet. `exposed` is the middle of the exposure of row 0.
  ///
  /// @return as watch
  Result<void> shoot(const std::function<void(Side side, const Picture& picture, TimePoint exposed)>& see) const;

 private:
  using See = std::function<void(const Picture& picture, TimePoint exposed)>;

  CameraPair(PerSide<OpenCamera> supply, PerSide<std::unique_ptr<Camera>> cameras, const Config& config,
             const ExposureSetting& setting)
      : supply_(std::move(supply)), cameras_(std::move(cameras)), rate_hz_(config.cameras.rate_hz), setting_(setting) {}

  [[nodiscard]] Result<void> show(Side side, int pictures, const See& see) const;

  PerSide<OpenCamera> supply_;  ///< owns what simulated cameras look at: it goes last
  PerSide<std::unique_ptr<Camera>> cameras_;
  double rate_hz_;
  ExposureSetting setting_;
};

}  // namespace tripoint
