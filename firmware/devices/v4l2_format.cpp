#include "devices/v4l2_format.h"

#include <fmt/format.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace tripoint {
namespace {

constexpr std::uint32_t kMostOffers = 64;     // of each kind; a driver that never ends its list is stopped here
constexpr double kRateTolerance = 0.02;       // 333333 x 100 ns is 30.00003 Hz
constexpr double kUsb2Video_mb_per_s = 24.0;  // isochronous: 3 x 1024 bytes in each of 8000 microframes a second

std::uint32_t fourcc_of(PixelFormat format) {
  switch (format) {
    case PixelFormat::kMjpeg:
      return V4L2_PIX_FMT_MJPEG;
    case PixelFormat::kGrey:
      return V4L2_PIX_FMT_GREY;
    case PixelFormat::kYuyv:
      break;
  }
  return V4L2_PIX_FMT_YUYV;
}

std::string text_of(std::uint32_t fourcc) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(fourcc >> shift & 0x7FU);
  return text;
}

std::size_t bytes_of_pixel(PixelFormat format) { return format == PixelFormat::kYuyv ? 2 : 1; }

double rate_of(const v4l2_fract& period) {
  return period.numerator == 0 ? 0.0 : static_cast<double>(period.denominator) / period.numerator;
}

std::string rates_offered(const V4l2Device& device, std::uint32_t fourcc, const v4l2_frmsize_discrete& size) {
  std::string rates;
  v4l2_frmivalenum interval{};
  interval.pixel_format = fourcc;
  interval.width = size.width;
  interval.height = size.height;
  for (; interval.index < kMostOffers; ++interval.index) {
    if (device.try_control(VIDIOC_ENUM_FRAMEINTERVALS, interval) < 0) break;
    if (interval.type != V4L2_FRMIVAL_TYPE_DISCRETE) break;
    rates += fmt::format("{}{:.4g}", rates.empty() ? "" : ", ", rate_of(interval.discrete));
  }
  return rates.empty() ? "" : fmt::format(" at {} Hz", rates);
}

void add_sizes(const V4l2Device& device, std::uint32_t fourcc, std::vector<std::string>& offers) {
  v4l2_frmsizeenum size{};
  size.pixel_format = fourcc;
  for (; size.index < kMostOffers; ++size.index) {
    if (device.try_control(VIDIOC_ENUM_FRAMESIZES, size) < 0) return;
    if (size.type != V4L2_FRMSIZE_TYPE_DISCRETE) {
      offers.push_back(fmt::format("{} {}x{} to {}x{}", text_of(fourcc), size.stepwise.min_width,
                                   size.stepwise.min_height, size.stepwise.max_width, size.stepwise.max_height));
      return;
    }
    offers.push_back(fmt::format("{} {}x{}{}", text_of(fourcc), size.discrete.width, size.discrete.height,
                                 rates_offered(device, fourcc, size.discrete)));
  }
}

tl::unexpected<Error> not_offered(const V4l2Device& device, const V4l2Settings& wanted, std::string_view got) {
  const std::vector<std::string> offers = formats_offered(device);
  return failure(ErrorCode::kNoSuchFormat,
                 fmt::format("{}: {} {}x{} at {:.4g} Hz is not offered (it answered {}); it offers: {}", device.name(),
                             name(wanted.format), wanted.size.width_px, wanted.size.height_px, wanted.rate_hz, got,
                             offers.empty() ? "nothing" : fmt::format("{}", fmt::join(offers, "; "))));
}

/// The driver knows the device well, but not this request or these values.
bool unable(int result) { return result == -EINVAL || result == -ENOTTY; }

Result<V4l2Format> set_pixels(const V4l2Device& device, const V4l2Settings& settings) {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_pix_format& pix = format.fmt.pix;
  pix.width = static_cast<std::uint32_t>(settings.size.width_px);
  pix.height = static_cast<std::uint32_t>(settings.size.height_px);
  pix.pixelformat = fourcc_of(settings.format);
  pix.field = V4L2_FIELD_NONE;
  const v4l2_pix_format asked = pix;
  const int set = device.try_control(VIDIOC_S_FMT, format);
  if (unable(set)) return not_offered(device, settings, "no");
  if (set < 0) return tl::make_unexpected(device.error(set, "set the picture format"));
  if (pix.width != asked.width || pix.height != asked.height || pix.pixelformat != asked.pixelformat) {
    return not_offered(device, settings, fmt::format("{} {}x{}", text_of(pix.pixelformat), pix.width, pix.height));
  }
  if (pix.field != V4L2_FIELD_NONE) return not_offered(device, settings, "interlaced pictures");
  if (settings.format == PixelFormat::kMjpeg) return V4l2Format{};
  const std::size_t least = asked.width * bytes_of_pixel(settings.format);
  return V4l2Format{.stride_bytes = std::max<std::size_t>(pix.bytesperline, least)};
}

Result<double> set_rate(const V4l2Device& device, const V4l2Settings& settings) {
  constexpr std::uint32_t kThousandths = 1000;
  v4l2_streamparm parameters{};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  parameters.parm.capture.timeperframe = {kThousandths,
                                          static_cast<std::uint32_t>(std::lround(settings.rate_hz * kThousandths))};
  const int set = device.try_control(VIDIOC_S_PARM, parameters);
  if (unable(set)) return not_offered(device, settings, "that its rate cannot be set");
  if (set < 0) return tl::make_unexpected(device.error(set, "set the frame rate"));
  const double rate_hz = rate_of(parameters.parm.capture.timeperframe);
  if (std::abs(rate_hz - settings.rate_hz) > kRateTolerance * settings.rate_hz) {
    return not_offered(device, settings, fmt::format("{:.4g} Hz", rate_hz));
  }
  return rate_hz;
}

}  // namespace

std::string_view name(PixelFormat format) {
  switch (format) {
    case PixelFormat::kMjpeg:
      return "MJPEG";
    case PixelFormat::kGrey:
      return "GREY";
    case PixelFormat::kYuyv:
      break;
  }
  return "YUYV";
}

Result<V4l2Format> set_format(const V4l2Device& device, const V4l2Settings& settings) {
  Result<V4l2Format> format = set_pixels(device, settings);
  if (!format) return format;
  const Result<double> rate_hz = set_rate(device, settings);
  if (!rate_hz) return tl::make_unexpected(rate_hz.error());
  format->rate_hz = *rate_hz;
  return format;
}

std::vector<std::string> formats_offered(const V4l2Device& device) {
  std::vector<std::string> offers;
  v4l2_fmtdesc format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  for (; format.index < kMostOffers; ++format.index) {
    if (device.try_control(VIDIOC_ENUM_FMT, format) < 0) break;
    add_sizes(device, format.pixelformat, offers);
  }
  return offers;
}

Result<bool> captures(const V4l2Device& device) {
  v4l2_capability capability{};
  const int asked = device.try_control(VIDIOC_QUERYCAP, capability);
  if (unable(asked)) return false;
  if (asked < 0) return tl::make_unexpected(device.error(asked, "ask what it can do"));
  const bool per_node = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
  const std::uint32_t able = per_node ? capability.device_caps : capability.capabilities;
  return (able & V4L2_CAP_VIDEO_CAPTURE) != 0 && (able & V4L2_CAP_STREAMING) != 0;
}

std::string bandwidth_explained(const V4l2Settings& settings) {
  const double pixels_per_s = static_cast<double>(settings.size.width_px) * settings.size.height_px * settings.rate_hz;
  const std::string stream = fmt::format("{} {}x{} at {:.4g} Hz", name(settings.format), settings.size.width_px,
                                         settings.size.height_px, settings.rate_hz);
  if (settings.format == PixelFormat::kMjpeg) {
    return fmt::format(
        "no room on the USB bus for {}: the camera reserves what it may need at most; plug the cameras "
        "into ports of different USB controllers, or ask for a smaller size",
        stream);
  }
  const double needed = pixels_per_s * static_cast<double>(bytes_of_pixel(settings.format)) / 1e6;
  return fmt::format(
      "no room on the USB bus: {} needs {:.1f} MB/s, two cameras {:.1f} MB/s, and a USB 2 bus carries "
      "about {:.0f} MB/s of video; plug the cameras into ports of different USB controllers, or ask "
      "for mjpeg, a smaller size or a lower rate",
      stream, needed, 2.0 * needed, kUsb2Video_mb_per_s);
}

}  // namespace tripoint
