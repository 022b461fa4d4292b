#include "devices/v4l2_camera.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <utility>

#include "devices/v4l2_controls.h"
#include "devices/v4l2_format.h"

namespace tripoint {
namespace {

std::string display_name(const V4l2Settings& settings) {
  std::string place = settings.port.empty() ? settings.node.string() : "usb " + settings.port;
  if (!settings.serial.empty()) place += ", " + settings.serial;
  return fmt::format("{} ({})", name(settings.side), place);
}

/// A full bus is the error that people cannot read from the driver's one word.
Error explained(const Error& error, const V4l2Device& device, const V4l2Settings& settings) {
  if (error.code != ErrorCode::kNoBandwidth) return error;
  return {error.code, fmt::format("{}: {}", device.name(), bandwidth_explained(settings))};
}

}  // namespace

Result<std::unique_ptr<V4l2Camera>> V4l2Camera::open(const V4l2Settings& settings, V4l2Driver& driver,
                                                     const Clock& clock) {
  Result<V4l2Device> device = V4l2Device::open(driver, settings.node, display_name(settings));
  if (!device) return tl::make_unexpected(device.error());
  const Result<bool> able = captures(*device);
  if (!able) return tl::make_unexpected(able.error());
  if (!*able) {
    return failure(ErrorCode::kNoSuchFormat, fmt::format("{}: {} delivers no pictures; `tripointd cameras` lists those "
                                                         "that do",
                                                         device->name(), settings.node.string()));
  }
  const Result<V4l2Format> format = set_format(*device, settings);
  if (!format) return tl::make_unexpected(explained(format.error(), *device, settings));
  Result<V4l2Controls> controls = set_controls(*device, settings);
  if (!controls) return tl::make_unexpected(controls.error());
  const std::string name = device->name();
  Result<V4l2Buffers> buffers = V4l2Buffers::start(std::move(*device)).map_error([&](const Error& error) {
    return error.code == ErrorCode::kNoBandwidth ? Error{error.code, name + ": " + bandwidth_explained(settings)}
                                                 : error;
  });
  if (!buffers) return tl::make_unexpected(buffers.error());

  std::unique_ptr<V4l2Camera> camera(new V4l2Camera(settings, std::move(*buffers), clock));
  camera->stride_bytes_ = format->stride_bytes;
  camera->stamp_point_ = driver.stamp_point();
  camera->info_ = {.name = name,
                   .port = settings.port,
                   .serial = settings.serial,
                   .size = settings.size,
                   .format = settings.format,
                   .rate_hz = format->rate_hz,
                   .exposure = controls->exposure,
                   .shortest_exposure = controls->shortest_exposure,
                   .longest_exposure = controls->longest_exposure,
                   .gain = controls->gain,
                   .gains = controls->gains,
                   .missing_controls = std::move(controls->missing)};
  return camera;
}

Result<Frame> V4l2Camera::next_frame(Duration limit) {
  if (held_) {
    const Result<void> given = buffers_.give_back(*std::exchange(held_, std::nullopt));
    if (!given) return tl::make_unexpected(given.error());
  }
  const Result<FilledBuffer> filled = wait_for_buffer(limit);
  if (!filled) return tl::make_unexpected(filled.error());
  held_ = filled->index;
  return frame_from(*filled);
}

Result<FilledBuffer> V4l2Camera::wait_for_buffer(Duration limit) {
  const TimePoint deadline = clock_.now() + limit;
  const V4l2Device& device = buffers_.device();
  do {
    const int events = device.wait(std::max(deadline - clock_.now(), Duration{0}));
    if (events < 0) return tl::make_unexpected(device.error(events, "wait for a frame"));
    if (events == 0) break;
    const Result<std::optional<FilledBuffer>> filled = buffers_.newest();
    const bool broken = (events & (POLLERR | POLLHUP | POLLNVAL)) != 0;
    if (!filled && !(broken && filled.error().code == ErrorCode::kCorruptFrame)) {
      return tl::make_unexpected(filled.error());
    }
    if (filled && *filled) return **filled;
    if (broken) {
      return failure(ErrorCode::kDeviceMissing,
                     device.name() + ": unplugged, or its stream broke off; check the cable");
    }
  } while (clock_.now() < deadline);
  return failure(ErrorCode::kTimeout,
                 fmt::format("{}: no frame for {:.0f} ms; check cable and bus", device.name(), 1e3 * seconds(limit)));
}

Result<Frame> V4l2Camera::frame_from(const FilledBuffer& filled) const {
  const auto corrupt = [&](std::string_view why) {
    return failure(ErrorCode::kCorruptFrame, fmt::format("{}: frame {} {}", info_.name, filled.sequence, why));
  };
  if (filled.damaged) return corrupt("was damaged on the way, says the driver");
  const std::size_t needed =
      std::max<std::size_t>(1, stride_bytes_ * static_cast<std::size_t>(settings_.size.height_px));
  if (filled.bytes.size() < needed) return corrupt(fmt::format("has {} of {} bytes", filled.bytes.size(), needed));
  if (!filled.stamp) {
    return failure(ErrorCode::kDeviceFault,
                   fmt::format("{}: its driver does not stamp frames by the monotonic clock, so when they were exposed "
                               "is unknown; use another camera, or another kernel",
                               info_.name));
  }
  const TimePoint arrived = clock_.now();
  return Frame{.side = settings_.side,
               .format = settings_.format,
               .size = settings_.size,
               .stride_bytes = stride_bytes_,
               .data = filled.bytes,
               .sequence = filled.sequence,
               .exposed = middle_of_exposure(*filled.stamp, stamp_point_, info_.exposure),
               .arrived = arrived,
               .line_time = settings_.line_time};
}

}  // namespace tripoint
