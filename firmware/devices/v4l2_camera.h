// A real camera through Video4Linux.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/v4l2_buffers.h"
#include "devices/v4l2_driver.h"
#include "devices/v4l2_settings.h"
#include "ports/camera.h"
#include "ports/clock.h"

namespace tripoint {

class V4l2Camera final : public Camera {
 public:
  /// Opens the node, fixes format, rate and controls, reads all of them back, and starts the stream.
  ///
  /// @param driver, clock  must outlive the camera
  /// @return kDeviceMissing, kDeviceBusy, kNoSuchFormat (naming what is offered), kControlRefused (naming the control),
  ///   kNoBandwidth (with the load computed), kDeviceFault
  static Result<std::unique_ptr<V4l2Camera>> open(const V4l2Settings& settings, V4l2Driver& driver, const Clock& clock);

  ~V4l2Camera() override = default;

  /// As Camera says; frames that the driver marked, or that are shorter than their size, are kCorruptFrame, and stamps
  /// of another clock than the monotonic one a kDeviceFault.
  Result<Frame> next_frame(Duration limit) override;
  [[nodiscard]] const CameraInfo& info() const override { return info_; }

 private:
  V4l2Camera(V4l2Settings settings, V4l2Buffers buffers, const Clock& clock)
      : settings_(std::move(settings)), buffers_(std::move(buffers)), clock_(clock) {}

  Result<FilledBuffer> wait_for_buffer(Duration limit);
  [[nodiscard]] Result<Frame> frame_from(const FilledBuffer& filled) const;

  V4l2Settings settings_;
  V4l2Buffers buffers_;
  const Clock& clock_;
  std::size_t stride_bytes_ = 0;
  StampPoint stamp_point_ = StampPoint::kFirstByte;
  CameraInfo info_;
  std::optional<std::uint32_t> held_;  ///< the buffer that the last frame looks into
};

}  // namespace tripoint
