// The narrow interface behind which real, recorded and simulated cameras look the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ports/frame.h"
#include "values/result.h"

namespace tripoint {

/// The gains that a camera offers, in its own unit.
struct GainRange {
  int lowest = 0;
  int highest = 0;
  int step = 1;
  friend bool operator==(const GainRange&, const GainRange&) = default;
};

/// What is known about an open camera; read back from the device, not assumed.
struct CameraInfo {
  std::string name;    ///< for people: "left (usb 1-1, LEFT-001)"
  std::string port;    ///< USB port path, "" when not on USB
  std::string serial;  ///< "" when the camera has none
  ImageSize size;
  PixelFormat format = PixelFormat::kYuyv;
  double rate_hz = 0.0;
  Duration exposure{0};                       ///< 0 = not known
  Duration shortest_exposure{0};              ///< that it offers; 0 = not known
  Duration longest_exposure{0};               ///< the same
  std::optional<int> gain = {};               ///< nothing: it has none, or it is not known
  std::optional<GainRange> gains = {};        ///< the same
  std::vector<std::string> missing_controls;  ///< that it does not have; its automatics may then change the picture
};

class Camera {
 public:
  Camera() = default;
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;
  virtual ~Camera() = default;

  /// The newest frame, waiting at most `limit`. Older ones that queued up are dropped.
  ///
  /// @return a view that is valid until the next call
  ///   kTimeout        nothing came; the camera may come back
  ///   kCorruptFrame   a damaged frame; ask again
  ///   kEndOfStream    a recording is over
  ///   kDeviceMissing  unplugged: close and open anew
  ///   kDeviceFault    the driver reported another error: close and open anew
  virtual Result<Frame> next_frame(Duration limit) = 0;

  [[nodiscard]] virtual const CameraInfo& info() const = 0;
};

}  // namespace tripoint
