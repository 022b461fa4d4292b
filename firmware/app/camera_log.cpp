#include "app/camera_log.h"

#include <spdlog/spdlog.h>

namespace tripoint {

void CameraLog::take(const PerSide<CameraStatus>& cameras) {
  for (const Side side : kBothSides) {
    const CameraStatus& camera = cameras[side];
    if (camera.last_error != last_error_[side]) {
      spdlog::warn("{}", camera.last_error);
      last_error_[side] = camera.last_error;
    }
    if (camera.delivering != delivering_[side]) {
      if (camera.delivering) spdlog::info("camera {}: delivers, {}", name(side), camera.info.name);
      delivering_[side] = camera.delivering;
    }
  }
}

}  // namespace tripoint
