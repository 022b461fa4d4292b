// The noise of a sensor, at its least: what makes every picture of a still scene another one.
#pragma once

#include <cstdint>

#include "descriptors.h"
#include "usbip.h"

namespace tripoint::uvc {

/// The picture with the lowest 16 bits of the frame's number in its upper left corner, each as a step of one or two
/// levels of brightness: no two frames within half an hour are equal once decoded.
Bytes with_noise(const Bytes& picture, Format format, std::uint64_t frame);

}  // namespace tripoint::uvc
