// What the camera says of itself: the descriptors of a webcam with YUYV and MJPEG at 640x480.
// Source: USB 2.0, chapter 9; USB Device Class Definition for Video Devices 1.1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "usbip.h"

namespace tripoint::uvc {

inline constexpr std::uint16_t kWidthPx = 640;
inline constexpr std::uint16_t kHeightPx = 480;
inline constexpr std::size_t kYuyvBytes = std::size_t{kWidthPx} * kHeightPx * 2;
inline constexpr std::uint32_t kPacketBytes =
    3072;  ///< three transactions of 1024 in a microframe: the most USB 2.0 has
inline constexpr std::uint32_t kClockHz = 48'000'000;  ///< of the time stamps in the payload headers
/// Frame intervals on offer, in the class's unit of 100 ns: 30, 15, 10 and 5 frames per second.
inline constexpr std::array<std::uint32_t, 4> kIntervals{333'333, 666'666, 1'000'000, 2'000'000};

inline constexpr std::uint8_t kControlInterface = 0;
inline constexpr std::uint8_t kStreamingInterface = 1;
inline constexpr std::uint8_t kCameraTerminal = 1;
inline constexpr std::uint8_t kProcessingUnit = 2;

/// Numbers under which the formats are described.
enum class Format : std::uint8_t { kYuyv = 1, kMjpeg = 2 };

Bytes device_descriptor();
Bytes device_qualifier();
Bytes configuration_descriptor();
/// 0 is the list of languages, then manufacturer, product and serial number; empty for others.
Bytes string_descriptor(std::uint8_t index, std::string_view serial);

}  // namespace tripoint::uvc
