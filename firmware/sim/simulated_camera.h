// A camera of the simulated world behind the same interface as a real one, in real time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "ports/camera.h"
#include "ports/clock.h"
#include "sim/frame_schedule.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint {

/// Sleeps in real time by this clock, which must outlive what is returned.
WaitUntil sleeping_by(const Clock& clock);

/// Renders a frame while its exposure lasts and hands it out when it would have been read out; with lights that are
/// switched it renders after that. The motion follows UTC:
/// the target is where the trajectory is at the frame's time since 1970.
class SimulatedCamera final : public Camera {
 public:
  /// World and clock must outlive the camera.
  /// @return kDeviceMissing while the plan of troubles keeps it unplugged
  static Result<std::unique_ptr<SimulatedCamera>> open(const SimulatedWorld& world, Side side, const Clock& clock,
                                                       WaitUntil wait_until);

  /// As Camera says; the sequence number counts from the opening and leaves gaps for frames that nobody fetched.
  Result<Frame> next_frame(Duration limit) override;
  [[nodiscard]] const CameraInfo& info() const override { return info_; }

  /// Of the frame last handed out.
  [[nodiscard]] const FrameTruth& truth() const { return truth_; }

 private:
  SimulatedCamera(const SimulatedWorld& world, Side side, const Clock& clock, WaitUntil wait_until);

  [[nodiscard]] bool has_trouble(Trouble trouble, TimePoint at) const;
  [[nodiscard]] std::uint64_t next_number(TimePoint now, TimePoint deadline) const;
  void take(std::uint64_t number);
  [[nodiscard]] Frame frame(std::uint64_t number) const;

  const SimulatedWorld& world_;
  Side side_;
  const Clock& clock_;
  WaitUntil wait_until_;
  FrameSchedule schedule_;
  FrameRenderer renderer_;
  CameraInfo info_;
  std::uint64_t first_number_;
  std::uint64_t next_number_;
  bool lost_ = false;
  const RenderedFrame* rendered_ = nullptr;  ///< owned by the renderer
  FrameTruth truth_;
};

}  // namespace tripoint
