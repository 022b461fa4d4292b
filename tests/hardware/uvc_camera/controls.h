// The settings of the camera as a real webcam has them: what may be set, to what, and when it refuses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "usbip.h"

namespace tripoint::uvc {

/// One setting. Values are little-endian on the wire, `bytes` long.
struct Control {
  const char* name;
  std::uint8_t entity;    ///< camera terminal or processing unit
  std::uint8_t selector;  ///< number within the entity
  std::uint8_t bytes;
  std::int32_t min, max, step, start;
  std::int32_t value;
};

/// Requests of the video class (UVC 1.1, table A-8).
enum class ClassRequest : std::uint8_t {
  kSetCurrent = 0x01,
  kGetCurrent = 0x81,
  kGetMin = 0x82,
  kGetMax = 0x83,
  kGetStep = 0x84,
  kGetLength = 0x85,
  kGetInfo = 0x86,
  kGetDefault = 0x87,
};

/// All settings of one camera. A manual value is refused while its automatic is on, as real cameras do.
class Controls {
 public:
  Controls();

  /// The data to answer with (empty for a set); nothing when the request is refused, with the reason in last_error().
  std::optional<Bytes> answer(const Setup& setup, std::span<const std::uint8_t> sent);
  /// Why the last request was refused (UVC 1.1, 4.2.1.2); 0: it was not.
  [[nodiscard]] std::uint8_t last_error() const { return last_error_; }
  /// "exposure_mode=8 exposure_time=157 ...": what the camera holds, for the test's own eyes.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] Control* find(std::uint8_t entity, std::uint8_t selector);
  [[nodiscard]] std::int32_t value_of(const char* name) const;
  [[nodiscard]] bool is_automatic(const Control& control) const;
  std::optional<Bytes> set(Control& control, std::span<const std::uint8_t> sent);
  std::optional<Bytes> refused(std::uint8_t error);

  std::array<Control, 10> controls_;
  std::uint8_t last_error_ = 0;
};

}  // namespace tripoint::uvc
