#include "camera.h"

#include <algorithm>
#include <array>
#include <utility>

#include "descriptors.h"

namespace tripoint::uvc {
namespace {

using namespace std::chrono_literals;

constexpr auto kLookUp = 20ms;       // how long an order of the test may wait
constexpr auto kSilence = 1s;        // for what is under way to arrive, also in an emulated machine
constexpr auto kMicroframe = 125us;  // one packet each

// Standard requests (USB 2.0, table 9-4).
constexpr std::uint8_t kGetStatus = 0, kClearFeature = 1, kGetDescriptor = 6, kGetConfiguration = 8,
                       kSetConfiguration = 9, kGetInterface = 10, kSetInterface = 11;
constexpr std::uint8_t kDeviceType = 1, kConfigurationType = 2, kStringType = 3, kQualifierType = 6;
constexpr std::uint8_t kRecipientMask = 0x1f, kToInterface = 1, kTypeMask = 0x60, kClassType = 0x20;
constexpr std::uint8_t kErrorCodeSelector = 2;  // VC_REQUEST_ERROR_CODE_CONTROL

}  // namespace

Camera::Camera(std::string serial, Pictures pictures, const Playlist& playlist, Time epoch)
    : serial_(std::move(serial)), pictures_(std::move(pictures)), payloads_(pictures_, playlist, epoch) {}

void Camera::run(const Socket& listener, std::stop_token stop) {
  while (!stop.stop_requested()) {
    const auto host = listener.accepted_within(kLookUp);
    if (!host) continue;
    power_up();
    serve(*host, stop);
  }
}

std::string Camera::settings() const {
  const std::scoped_lock lock(settings_guard_);
  return controls_.text();
}

void Camera::power_up() {
  const std::scoped_lock lock(settings_guard_);
  controls_ = Controls{};
  negotiation_ = Negotiation{};
  alternate_ = 0;
  waiting_.clear();
  unplugged_ = false;
  hung_ = false;
}

void Camera::serve(const Socket& host, const std::stop_token& stop) {
  while (!stop.stop_requested() && !unplugged_) {
    if (host.readable_within(wait_time(std::chrono::steady_clock::now()))) {
      const auto request = read_request(host);
      if (!request || !handle(host, *request)) return;
    } else if (!stream(host, std::chrono::steady_clock::now())) {
      return;
    }
  }
  fall_silent(host, stop);
}

/// vhci_hcd completes transfers in one thread and takes a lost device apart in another; pictures still under way then
/// corrupt uvcvideo's queue of buffers (BUG at lib/list_debug.c in Linux 6.1). So the pictures end before the cable
/// goes.
void Camera::fall_silent(const Socket& host, const std::stop_token& stop) {
  hung_ = true;
  const Time end = std::chrono::steady_clock::now() + kSilence;
  while (!stop.stop_requested() && std::chrono::steady_clock::now() < end) {
    if (!host.readable_within(kLookUp)) continue;
    const auto request = read_request(host);
    if (!request || !handle(host, *request)) return;
  }
}

/// Until there is something to send. Empty microframes are left out: each would cost the emulated processor as much as
/// a full one, and the driver does not miss them.
std::chrono::nanoseconds Camera::wait_time(Time now) const {
  if (alternate_ == 0 || waiting_.empty() || hung_) return kLookUp;
  const Time due = payloads_.pending(now) ? next_transfer_ : std::max(next_transfer_, payloads_.next_frame());
  return std::clamp<std::chrono::nanoseconds>(due - now, 0ns, kLookUp);
}

bool Camera::handle(const Socket& host, const Request& request) {
  if (const auto* unlink = std::get_if<Unlink>(&request)) {
    const auto taken_back =
        std::erase_if(waiting_, [&](const Submit& submit) { return submit.sequence == unlink->victim; });
    return host.write_all(answer_to_unlink(*unlink, taken_back > 0 ? Status::kUnlinked : Status::kDone));
  }
  const auto& submit = std::get<Submit>(request);
  if (submit.endpoint != 0) {
    waiting_.push_back(submit);
    return true;
  }
  auto data = answer(submit.setup, submit.sent);
  if (!data) return host.write_all(answer_to_control(submit, Status::kStalled, {}));
  data->resize(std::min<std::size_t>(data->size(), submit.setup.length));
  return host.write_all(answer_to_control(submit, Status::kDone, *data));
}

bool Camera::stream(const Socket& host, Time now) {
  if (alternate_ == 0 || waiting_.empty() || hung_ || now < next_transfer_ || !payloads_.pending(now)) return true;
  const Submit submit = std::move(waiting_.front());
  waiting_.pop_front();
  Bytes payloads;
  std::vector<std::uint32_t> lengths;
  std::array<std::uint8_t, kPacketBytes> packet{};
  for (const IsoPacket& asked : submit.packets) {
    const std::size_t length =
        payloads_.write(std::span{packet}.first(std::min<std::size_t>(asked.length, packet.size())), now);
    payloads.insert(payloads.end(), packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(length));
    lengths.push_back(static_cast<std::uint32_t>(length));
  }
  next_transfer_ = now + kMicroframe * static_cast<std::int64_t>(submit.packets.size());
  return host.write_all(answer_to_iso(submit, payloads, lengths));
}

std::optional<Bytes> Camera::answer(const Setup& setup, std::span<const std::uint8_t> sent) {
  const std::scoped_lock lock(settings_guard_);
  if ((setup.request_type & kTypeMask) == kClassType) return answer_from_interface(setup, sent);
  return answer_from_device(setup);
}

std::optional<Bytes> Camera::answer_from_interface(const Setup& setup, std::span<const std::uint8_t> sent) {
  const auto interface = static_cast<std::uint8_t>(setup.index);
  if (interface == kStreamingInterface) return negotiation_.answer(setup, sent);
  if (setup.index == kControlInterface && setup.value >> 8 == kErrorCodeSelector) return Bytes{controls_.last_error()};
  return controls_.answer(setup, sent);
}

std::optional<Bytes> Camera::described(std::uint16_t what) const {
  switch (what >> 8) {
    case kDeviceType:
      return device_descriptor();
    case kConfigurationType:
      return configuration_descriptor();
    case kQualifierType:
      return device_qualifier();
    case kStringType: {
      Bytes text = string_descriptor(static_cast<std::uint8_t>(what), serial_);
      return text.empty() ? std::nullopt : std::optional{std::move(text)};
    }
    default:
      return std::nullopt;
  }
}

std::optional<Bytes> Camera::answer_from_device(const Setup& setup) {
  const bool of_streaming = (setup.request_type & kRecipientMask) == kToInterface && setup.index == kStreamingInterface;
  switch (setup.request) {
    case kGetDescriptor:
      return described(setup.value);
    case kGetStatus:
      return Bytes{0, 0};
    case kGetConfiguration:
      return Bytes{1};
    case kGetInterface:
      return Bytes{of_streaming ? alternate_ : std::uint8_t{0}};
    case kSetInterface:
      if (of_streaming) select(static_cast<std::uint8_t>(setup.value));
      return Bytes{};
    case kSetConfiguration:
      select(0);
      return Bytes{};
    case kClearFeature:
      return Bytes{};
    default:
      return std::nullopt;
  }
}

void Camera::select(std::uint8_t alternate) {
  alternate_ = alternate;
  payloads_.begin(negotiation_.committed(), std::chrono::steady_clock::now());
}

}  // namespace tripoint::uvc
