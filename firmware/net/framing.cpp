#include "net/framing.h"

namespace tripoint {
namespace {

constexpr std::size_t kBeforeLength = 6;  // transaction, protocol, length
constexpr std::size_t kHeader = 7;        // and the unit id, which the length counts
constexpr unsigned kShortestLength = 2;
constexpr unsigned kLongestLength = 254;

void append_answer(Turn& turn, std::span<const std::uint8_t> frame, const Pdu& pdu) {
  const std::size_t length = pdu.size() + 1;
  turn.output.push_back(frame[0]);
  turn.output.push_back(frame[1]);
  turn.output.push_back(0);
  turn.output.push_back(0);
  turn.output.push_back(static_cast<std::uint8_t>(length >> 8U));
  turn.output.push_back(static_cast<std::uint8_t>(length & 0xFFU));
  turn.output.push_back(frame[6]);
  for (const std::uint8_t byte : pdu) turn.output.push_back(byte);
}

}  // namespace

Frame first_frame(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kBeforeLength) return Frame{};
  const unsigned protocol = word_at(bytes, 2);
  const unsigned length = word_at(bytes, 4);
  if (protocol != 0 || length < kShortestLength || length > kLongestLength) return Frame{FrameState::kBroken, 0, {}};
  if (bytes.size() < kBeforeLength + length) return Frame{};
  return Frame{FrameState::kWhole, kBeforeLength + length, bytes.subspan(kHeader, length - 1)};
}

Turn turn_of(std::span<const std::uint8_t> input, const AnswerPdu& answer) {
  Turn turn;
  Frame frame = first_frame(input);
  while (frame.state == FrameState::kWhole && turn.requests < kFramesPerTurn) {
    append_answer(turn, input.subspan(turn.consumed, frame.length), answer(frame.pdu));
    turn.consumed += frame.length;
    ++turn.requests;
    frame = first_frame(input.subspan(turn.consumed));
  }
  turn.more = frame.state == FrameState::kWhole;
  turn.broken = frame.state == FrameState::kBroken;
  return turn;
}

}  // namespace tripoint
