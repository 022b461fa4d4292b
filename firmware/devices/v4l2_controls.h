// Exposure, gain, white balance and focus: fixed, and read back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/v4l2_device.h"
#include "devices/v4l2_settings.h"
#include "ports/camera.h"

namespace tripoint {

struct V4l2Controls {
  Duration exposure{0};           ///< as the camera rounded it
  Duration shortest_exposure{0};  ///< that the camera offers
  Duration longest_exposure{0};
  std::optional<int> gain;  ///< as read back
  std::optional<GainRange> gains;
  std::vector<std::string> missing;  ///< names of controls that the camera does not have
};

/// Turns every automatic off, then sets the values.
///
/// @return kControlRefused, naming control, wanted, got and range, when a control reads back another value or the
/// camera
///   has no manual exposure; errors of V4l2Device
Result<V4l2Controls> set_controls(const V4l2Device& device, const V4l2Settings& settings);

}  // namespace tripoint
