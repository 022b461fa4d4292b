// Both cameras opened at one exposure, and what they show of the target's LEDs.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "app/exposure_search.h"
#include "capture/camera_worker.h"
#include "config/config.h"

namespace tripoint {

/// How to open both cameras as a configuration says.
using SupplyCameras = std::function<Result<PerSide<OpenCamera>>(const Config& config)>;

class ExposureSight {
 public:
  /// @param leds  so many LEDs the target has
  ExposureSight(Config config, SupplyCameras supply, std::size_t leds)
      : config_(std::move(config)), supply_(std::move(supply)), leds_(leds) {}

  /// Opens both cameras anew with this exposure, and takes the median over some frames.
  ///
  /// @return `exposure` as read back; errors of opening (kDeviceMissing, kDeviceBusy, kControlRefused, ...), kTimeout
  ///   without frames, kMismatch when the cameras read back different exposures
  Result<Look> look(std::chrono::microseconds exposure);

  /// What both cameras offer at the configured rate: exposures up to the frame period. Opens them as configured.
  Result<ExposureRange> offered();

 private:
  /// The supply owns what simulated cameras look at: it goes last.
  struct Opened {
    PerSide<OpenCamera> supply;
    PerSide<std::unique_ptr<Camera>> cameras;
  };
  Result<Opened> open(std::chrono::microseconds exposure);

  Config config_;
  SupplyCameras supply_;
  std::size_t leds_;
};

}  // namespace tripoint
