#include "devices/v4l2_controls.h"

#include <fmt/format.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>

namespace tripoint {
namespace {

constexpr std::chrono::microseconds kExposureUnit{100};  // of V4L2_CID_EXPOSURE_ABSOLUTE

struct Setting {
  std::uint32_t id = 0;
  std::string_view name;
  int value = 0;
  bool required = false;
};

int exposure_units(std::chrono::microseconds exposure) {
  return static_cast<int>(std::max<std::int64_t>(1, (exposure + kExposureUnit / 2) / kExposureUnit));
}

/// Each automatic before the value that it would hold fast.
std::array<Setting, 9> settings_in_order(const V4l2Settings& wanted) {
  return {{
      {V4L2_CID_EXPOSURE_AUTO, "exposure_auto", V4L2_EXPOSURE_MANUAL, true},
      {V4L2_CID_EXPOSURE_AUTO_PRIORITY, "exposure_auto_priority", 0},
      {V4L2_CID_EXPOSURE_ABSOLUTE, "exposure_absolute", exposure_units(wanted.exposure), true},
      {V4L2_CID_AUTOGAIN, "gain_automatic", 0},
      {V4L2_CID_GAIN, "gain", wanted.gain},
      {V4L2_CID_AUTO_WHITE_BALANCE, "white_balance_automatic", 0},
      {V4L2_CID_WHITE_BALANCE_TEMPERATURE, "white_balance_temperature", wanted.white_balance_k},
      {V4L2_CID_FOCUS_AUTO, "focus_automatic_continuous", 0},
      {V4L2_CID_FOCUS_ABSOLUTE, "focus_absolute", wanted.focus},
  }};
}

/// What the device says about a control; nothing when it has none.
Result<std::optional<v4l2_queryctrl>> described(const V4l2Device& device, const Setting& setting) {
  v4l2_queryctrl description{};
  description.id = setting.id;
  const int asked = device.try_control(VIDIOC_QUERYCTRL, description);
  if (asked == -EINVAL || asked == -ENOTTY) return std::optional<v4l2_queryctrl>{};
  if (asked < 0) return tl::make_unexpected(device.error(asked, fmt::format("ask for {}", setting.name)));
  if ((description.flags & V4L2_CTRL_FLAG_DISABLED) != 0) return std::optional<v4l2_queryctrl>{};
  return description;
}

/// The camera's own answers to a value that it does not take, as uvcvideo gives them: out of range, invalid, not ready,
/// in the wrong state, without power. What is read back then tells.
bool refused(int result) {
  return result == -ERANGE || result == -EINVAL || result == -EBUSY || result == -EACCES || result == -EILSEQ ||
         result == -EREMOTE;
}

Result<void> set(const V4l2Device& device, const Setting& setting, const v4l2_queryctrl& range) {
  v4l2_control control{.id = setting.id, .value = setting.value};
  const int written = device.try_control(VIDIOC_S_CTRL, control);
  if (written < 0 && !refused(written)) {
    return tl::make_unexpected(device.error(written, fmt::format("set {}", setting.name)));
  }
  control.value = 0;
  const Result<void> read = device.control(VIDIOC_G_CTRL, control, fmt::format("read {}", setting.name));
  if (!read) return read;
  if (written == 0 && control.value == setting.value) return {};
  const std::string answer = written == 0 ? "" : fmt::format(" ({})", std::generic_category().message(-written));
  return failure(
      ErrorCode::kControlRefused,
      fmt::format("{}: {} wanted {}, got {}{}; the camera permits {} to {} in steps of {}", device.name(), setting.name,
                  setting.value, control.value, answer, range.minimum, range.maximum, range.step));
}

}  // namespace

Result<V4l2Controls> set_controls(const V4l2Device& device, const V4l2Settings& settings) {
  V4l2Controls result;
  result.exposure = exposure_units(settings.exposure) * kExposureUnit;
  for (const Setting& setting : settings_in_order(settings)) {
    const Result<std::optional<v4l2_queryctrl>> description = described(device, setting);
    if (!description) return tl::make_unexpected(description.error());
    if (!*description) {
      if (setting.required) {
        return failure(ErrorCode::kControlRefused,
                       fmt::format("{}: has no {}: its exposure cannot be fixed; use another camera", device.name(),
                                   setting.name));
      }
      result.missing.emplace_back(setting.name);
      continue;
    }
    if (setting.id == V4L2_CID_EXPOSURE_ABSOLUTE) {
      result.shortest_exposure = (*description)->minimum * kExposureUnit;
      result.longest_exposure = (*description)->maximum * kExposureUnit;
    }
    const Result<void> done = set(device, setting, **description);
    if (!done) return tl::make_unexpected(done.error());
    if (setting.id == V4L2_CID_GAIN) {
      result.gain = setting.value;
      result.gains = GainRange{(*description)->minimum, (*description)->maximum, std::max(1, (*description)->step)};
    }
  }
  return result;
}

}  // namespace tripoint
