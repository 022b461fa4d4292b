// What the log says about the cameras: each change once.
#pragma once

#include <cstdint>
#include <string>

#include "capture/camera_worker.h"
#include "values/side.h"

namespace tripoint {

class CameraLog {
 public:
  /// Logs what changed since the last call.
  void take(const PerSide<CameraStatus>& cameras);

 private:
  PerSide<bool> delivering_{false, false};
  PerSide<std::string> last_error_;
  PerSide<std::uint64_t> losses_{0, 0};
};

}  // namespace tripoint
