#include "app/camera_log.h"

#include <spdlog/spdlog.h>

namespace tripoint {
namespace {

void log_arrival(Side side, const CameraInfo& camera) {
  spdlog::info("camera {}: delivers, {}", name(side), camera.name);
  for (const std::string& control : camera.missing_controls) {
    spdlog::warn("camera {}: has no control for {}; watch that its automatics leave the picture alone", name(side),
                 control);
  }
}

}  // namespace

void CameraLog::take(const PerSide<CameraStatus>& cameras) {
  for (const Side side : kBothSides) {
    const CameraStatus& camera = cameras[side];
    if (camera.last_error != last_error_[side] || camera.losses != losses_[side]) {
      spdlog::warn("{}", camera.last_error);
      last_error_[side] = camera.last_error;
      losses_[side] = camera.losses;
    }
    if (camera.delivering != delivering_[side]) {
      if (camera.delivering) log_arrival(side, camera.info);
      delivering_[side] = camera.delivering;
    }
  }
}

}  // namespace tripoint
