#include "controls.h"

#include <algorithm>
#include <string_view>

#include "descriptors.h"

namespace tripoint::uvc {
namespace {

// Request error codes (UVC 1.1, 4.2.1.2).
constexpr std::uint8_t kWrongState = 2, kOutOfRange = 4, kInvalidControl = 6, kInvalidRequest = 7;

// Exposure modes are a bit each: 1 manual, 8 aperture priority (exposure automatic); steps are a mask of those on
// offer.
constexpr std::int32_t kManualExposure = 1, kApertureExposure = 8;

// Ranges and first values of a common webcam: all automatics on. Exposure time in 0.1 ms, white balance in K.
constexpr std::array<Control, 10> kControls{{
    {"exposure_mode", kCameraTerminal, 2, 1, 1, 8, kManualExposure | kApertureExposure, kApertureExposure,
     kApertureExposure},
    {"exposure_priority", kCameraTerminal, 3, 1, 0, 1, 1, 1, 1},
    {"exposure_time", kCameraTerminal, 4, 4, 1, 5000, 1, 157, 157},
    {"focus", kCameraTerminal, 6, 2, 0, 250, 5, 0, 0},
    {"focus_auto", kCameraTerminal, 8, 1, 0, 1, 1, 1, 1},
    {"brightness", kProcessingUnit, 2, 2, 0, 255, 1, 128, 128},
    {"gain", kProcessingUnit, 4, 2, 0, 255, 1, 64, 64},
    {"power_line", kProcessingUnit, 5, 1, 0, 2, 1, 2, 2},
    {"white_balance", kProcessingUnit, 10, 2, 2000, 6500, 1, 4000, 4000},
    {"white_balance_auto", kProcessingUnit, 11, 1, 0, 1, 1, 1, 1},
}};

Bytes little_endian(std::int32_t value, std::size_t bytes) {
  Bytes data;
  for (std::size_t i = 0; i < bytes; ++i)
    data.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> 8 * i));
  return data;
}

std::int32_t value_from(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint32_t{bytes[i]} << 8 * i;
  return static_cast<std::int32_t>(value);
}

}  // namespace

Controls::Controls() : controls_(kControls) {}

std::optional<Bytes> Controls::answer(const Setup& setup, std::span<const std::uint8_t> sent) {
  const auto entity = static_cast<std::uint8_t>(setup.index >> 8);
  const auto selector = static_cast<std::uint8_t>(setup.value >> 8);
  Control* control = find(entity, selector);
  if (control == nullptr) return refused(kInvalidControl);
  last_error_ = 0;
  switch (ClassRequest{setup.request}) {
    case ClassRequest::kSetCurrent:
      return set(*control, sent);
    case ClassRequest::kGetCurrent:
      return little_endian(control->value, control->bytes);
    case ClassRequest::kGetMin:
      return little_endian(control->min, control->bytes);
    case ClassRequest::kGetMax:
      return little_endian(control->max, control->bytes);
    case ClassRequest::kGetStep:
      return little_endian(control->step, control->bytes);
    case ClassRequest::kGetDefault:
      return little_endian(control->start, control->bytes);
    case ClassRequest::kGetLength:
      return little_endian(control->bytes, 2);
    case ClassRequest::kGetInfo:
      return Bytes{
          static_cast<std::uint8_t>(is_automatic(*control) ? 0x07 : 0x03)};  // readable, writable, held by an automatic
  }
  return refused(kInvalidRequest);
}

std::optional<Bytes> Controls::set(Control& control, std::span<const std::uint8_t> sent) {
  if (sent.size() != control.bytes) return refused(kInvalidRequest);
  const std::int32_t value = value_from(sent);
  if (value < control.min || value > control.max) return refused(kOutOfRange);
  if (is_automatic(control)) return refused(kWrongState);
  control.value = value;
  return Bytes{};
}

bool Controls::is_automatic(const Control& control) const {
  const std::string_view name = control.name;
  if (name == "exposure_time") return value_of("exposure_mode") != kManualExposure;
  if (name == "focus") return value_of("focus_auto") == 1;
  if (name == "white_balance") return value_of("white_balance_auto") == 1;
  return false;
}

std::optional<Bytes> Controls::refused(std::uint8_t error) {
  last_error_ = error;
  return std::nullopt;
}

Control* Controls::find(std::uint8_t entity, std::uint8_t selector) {
  const auto found = std::ranges::find_if(
      controls_, [&](const Control& control) { return control.entity == entity && control.selector == selector; });
  return found == controls_.end() ? nullptr : &*found;
}

std::int32_t Controls::value_of(const char* name) const {
  return std::ranges::find(controls_, std::string_view{name},
                           [](const Control& control) { return std::string_view{control.name}; })
      ->value;
}

std::string Controls::text() const {
  std::string text;
  for (const Control& control : controls_) {
    if (!text.empty()) text += ' ';
    text += std::string{control.name} + '=' + std::to_string(control.value);
  }
  return text;
}

}  // namespace tripoint::uvc
