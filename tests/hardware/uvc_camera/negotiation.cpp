#include "negotiation.h"

#include <algorithm>

#include "controls.h"

namespace tripoint::uvc {
namespace {

constexpr std::uint8_t kProbe = 1, kCommit = 2;
constexpr std::size_t kLength = 34;  // of the block in UVC 1.1
constexpr std::size_t kAtFormat = 2, kAtFrame = 3, kAtInterval = 4, kAtFrameBytes = 18, kAtPayloadBytes = 22,
                      kAtClock = 26, kAtFraming = 30;

void put_u32(Bytes& block, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) block[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}

std::uint32_t u32_at(std::span<const std::uint8_t> block, std::size_t at) {
  return std::uint32_t{block[at]} | std::uint32_t{block[at + 1]} << 8 | std::uint32_t{block[at + 2]} << 16 |
         std::uint32_t{block[at + 3]} << 24;
}

Bytes block_from(const StreamChoice& choice) {
  Bytes block(kLength);
  block[kAtFormat] = static_cast<std::uint8_t>(choice.format);
  block[kAtFrame] = 1;
  put_u32(block, kAtInterval, choice.interval);
  put_u32(block, kAtFrameBytes, kYuyvBytes);
  put_u32(block, kAtPayloadBytes, kPacketBytes);
  put_u32(block, kAtClock, kClockHz);
  block[kAtFraming] = 3;  // payload headers carry frame id and end of frame
  return block;
}

/// The nearest thing on offer, as the class asks of a camera.
StreamChoice choice_from(std::span<const std::uint8_t> block) {
  StreamChoice choice;
  if (block[kAtFormat] == static_cast<std::uint8_t>(Format::kMjpeg)) choice.format = Format::kMjpeg;
  const std::uint32_t wanted = u32_at(block, kAtInterval);
  choice.interval = *std::ranges::min_element(
      kIntervals, {}, [&](std::uint32_t offered) { return offered > wanted ? offered - wanted : wanted - offered; });
  return choice;
}

}  // namespace

std::optional<Bytes> Negotiation::answer(const Setup& setup, std::span<const std::uint8_t> sent) {
  const auto selector = static_cast<std::uint8_t>(setup.value >> 8);
  if (selector != kProbe && selector != kCommit) return std::nullopt;
  StreamChoice& choice = selector == kProbe ? probed_ : committed_;
  switch (ClassRequest{setup.request}) {
    case ClassRequest::kSetCurrent:
      if (sent.size() < kAtPayloadBytes + 4) return std::nullopt;
      choice = choice_from(sent);
      return Bytes{};
    case ClassRequest::kGetLength:
      return Bytes{kLength, 0};
    case ClassRequest::kGetInfo:
      return Bytes{0x03};
    case ClassRequest::kGetMin:
      return block_from({choice.format, kIntervals.front()});
    case ClassRequest::kGetMax:
      return block_from({choice.format, kIntervals.back()});
    case ClassRequest::kGetDefault:
      return block_from({});
    case ClassRequest::kGetCurrent:
      return block_from(choice);
    case ClassRequest::kGetStep:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace tripoint::uvc
