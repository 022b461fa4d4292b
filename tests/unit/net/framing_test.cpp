#include "net/framing.h"

#include <gtest/gtest.h>

#include <vector>

namespace tripoint {
namespace {

using Bytes = std::vector<std::uint8_t>;

Pdu echo(std::span<const std::uint8_t> pdu) {
  Pdu answer;
  append_bytes(answer, pdu);
  return answer;
}

Bytes frames(std::size_t count) {
  Bytes bytes;
  for (std::size_t i = 0; i < count; ++i) {
    for (const unsigned byte : {0U, static_cast<unsigned>(i), 0U, 0U, 0U, 3U, 17U, 3U, 9U}) {
      bytes.push_back(static_cast<std::uint8_t>(byte));
    }
  }
  return bytes;
}

TEST(FrameTest, IsWholeWhenItsDeclaredLengthIsThere) {
  const Bytes bytes = frames(1);
  EXPECT_EQ(first_frame(std::span(bytes).first(8)).state, FrameState::kIncomplete);
  const Frame frame = first_frame(bytes);
  EXPECT_EQ(frame.state, FrameState::kWhole);
  EXPECT_EQ(frame.length, 9U);
  EXPECT_EQ(frame.pdu.size(), 2U);
}

TEST(FrameTest, TheLengthMayBeFrom2To254) {
  for (const auto& [length, broken] : {std::pair{1, true}, {2, false}, {254, false}, {255, true}}) {
    const Bytes bytes{0, 0, 0, 0, 0, static_cast<std::uint8_t>(length)};
    EXPECT_EQ(first_frame(bytes).state == FrameState::kBroken, broken) << length;
  }
  EXPECT_EQ(first_frame(Bytes{0, 0, 0, 0, 1, 2}).state, FrameState::kBroken);
}

TEST(FrameTest, AnotherProtocolIsBroken) {
  EXPECT_EQ(first_frame(Bytes{0, 0, 0, 1, 0, 6}).state, FrameState::kBroken);
  EXPECT_EQ(first_frame(Bytes{0, 0, 1, 0, 0, 6}).state, FrameState::kBroken);
}

TEST(TurnTest, AnswersKeepTransactionAndUnit) {
  const Bytes bytes = frames(2);
  const Turn turn = turn_of(bytes, echo);
  EXPECT_EQ(turn.consumed, bytes.size());
  EXPECT_EQ(turn.requests, 2U);
  EXPECT_EQ(Bytes(turn.output.begin(), turn.output.end()), bytes);
}

TEST(TurnTest, EndsAfterItsShareAndSaysThatMoreWaits) {
  const Bytes bytes = frames(kFramesPerTurn + 1);
  const Turn turn = turn_of(bytes, echo);
  EXPECT_EQ(turn.requests, kFramesPerTurn);
  EXPECT_TRUE(turn.more);
  EXPECT_FALSE(turn_of(std::span(bytes).subspan(turn.consumed), echo).more);
}

TEST(TurnTest, TheLongestAnswersFit) {
  Pdu longest;
  while (!longest.full()) longest.push_back(1);
  const Turn turn = turn_of(frames(kFramesPerTurn), [&](auto) { return longest; });
  EXPECT_EQ(turn.output.size(), kTurnBytes);
}

TEST(TurnTest, ABrokenFrameEndsItAfterTheWholeOnes) {
  Bytes bytes = frames(1);
  bytes.insert(bytes.end(), {0, 0, 0, 9, 0, 6});
  const Turn turn = turn_of(bytes, echo);
  EXPECT_EQ(turn.requests, 1U);
  EXPECT_TRUE(turn.broken);
}

}  // namespace
}  // namespace tripoint
