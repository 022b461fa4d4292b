// Pixel format, size and rate of a camera: asked for, and read back.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "devices/v4l2_device.h"
#include "devices/v4l2_settings.h"

namespace tripoint {

/// What the camera agreed to.
struct V4l2Format {
  std::size_t stride_bytes = 0;  ///< 0 for MJPEG
  double rate_hz = 0.0;
};

/// @return kNoSuchFormat, naming what the camera offers, when it refuses or answers with interlaced pictures or
///         anything else than was asked for (2 % of the rate aside); errors of V4l2Device
Result<V4l2Format> set_format(const V4l2Device& device, const V4l2Settings& settings);

/// "YUYV 640x480 at 30, 15 Hz", one entry for each format and size.
std::vector<std::string> formats_offered(const V4l2Device& device);

/// False for a node that only carries metadata, a device that plays pictures, or one that is no video device.
///
/// @return errors of V4l2Device
Result<bool> captures(const V4l2Device& device);

std::string_view name(PixelFormat format);

/// What a stream of these settings needs of a USB 2 bus, and what to do when it is too much.
std::string bandwidth_explained(const V4l2Settings& settings);

}  // namespace tripoint
