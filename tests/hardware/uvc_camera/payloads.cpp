#include "payloads.h"

#include <algorithm>

#include "noise.h"

namespace tripoint::uvc {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::uint8_t kEndOfFrame = 1U << 1, kHasPictureTime = 1U << 2, kHasSourceClock = 1U << 3,
                       kEndOfHeader = 1U << 7;
constexpr std::uint64_t kBusFrameMask = 0x7ff;  // the bus counts its 1 ms frames in 11 bits

/// The camera's own clock, which wraps after 89 s.
std::uint32_t ticks(std::chrono::nanoseconds since_epoch) {
  using Ticks = std::chrono::duration<std::int64_t, std::ratio<1, kClockHz>>;
  return static_cast<std::uint32_t>(std::chrono::duration_cast<Ticks>(since_epoch).count());
}

void put_u32(std::span<std::uint8_t> bytes, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(value >> 8 * i);
}

}  // namespace

void Payloads::begin(const StreamChoice& choice, Time now) {
  choice_ = choice;
  frame_ = frame_at(now);
  remaining_ = {};
}

std::uint64_t Payloads::frame_at(Time now) const {
  return static_cast<std::uint64_t>((now - epoch_) / choice_.frame_time());
}

bool Payloads::pending(Time now) const { return !remaining_.empty() || frame_at(now) > frame_; }

Time Payloads::next_frame() const { return epoch_ + choice_.frame_time() * static_cast<std::int64_t>(frame_ + 1); }

std::size_t Payloads::write(std::span<std::uint8_t> packet, Time now) {
  if (!pending(now) || packet.size() <= kHeaderBytes) return 0;
  if (remaining_.empty()) {
    frame_ = frame_at(now);
    frame_id_ ^= 1U;
    const Showing showing = playlist_.at(frame_);
    picture_ = pictures_.at(choice_.format, showing.picture);
    if (showing.restless) picture_ = with_noise(picture_, choice_.format, frame_);
    remaining_ = picture_;
  }
  const std::size_t count = std::min(packet.size() - kHeaderBytes, remaining_.size());
  std::ranges::copy(remaining_.first(count), packet.begin() + kHeaderBytes);
  remaining_ = remaining_.subspan(count);
  write_header(packet, remaining_.empty(), now);
  return kHeaderBytes + count;
}

void Payloads::write_header(std::span<std::uint8_t> packet, bool last, Time now) const {
  const auto exposed = choice_.frame_time() * static_cast<std::int64_t>(frame_);
  const std::chrono::nanoseconds sent = now - epoch_;
  const auto bus_frame =
      static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(sent).count()) & kBusFrameMask;
  packet[0] = kHeaderBytes;
  packet[1] = static_cast<std::uint8_t>(kEndOfHeader | kHasSourceClock | kHasPictureTime | (last ? kEndOfFrame : 0U) |
                                        frame_id_);
  put_u32(packet.subspan(2), ticks(exposed));
  put_u32(packet.subspan(6), ticks(sent));
  packet[10] = static_cast<std::uint8_t>(bus_frame);
  packet[11] = static_cast<std::uint8_t>(bus_frame >> 8);
}

}  // namespace tripoint::uvc
