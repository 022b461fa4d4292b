// Modbus TCP frames: from the bytes that have arrived to the bytes to send. Pure: no socket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "serve/pdu.h"
#include "values/fixed_vector.h"

namespace tripoint {

inline constexpr std::size_t kLongestFrame = 260;  ///< 6 bytes before the length counts, 254 after
inline constexpr std::size_t kFramesPerTurn = 8;   ///< so many requests of one client, then the others have their turn
inline constexpr std::size_t kTurnBytes = kLongestFrame * kFramesPerTurn;

enum class FrameState : std::uint8_t {
  kIncomplete,  ///< more bytes must come
  kWhole,
  kBroken,  ///< not Modbus: wrong protocol id, or a length outside 2 to 254
};

/// The first frame in some bytes; `length` and `pdu` only when it is whole.
struct Frame {
  FrameState state = FrameState::kIncomplete;
  std::size_t length = 0;
  std::span<const std::uint8_t> pdu;
};

Frame first_frame(std::span<const std::uint8_t> bytes);

using AnswerPdu = std::function<Pdu(std::span<const std::uint8_t>)>;

/// What one turn of a client brings.
struct Turn {
  std::size_t consumed = 0;  ///< bytes of the input that are done with
  std::size_t requests = 0;
  bool more = false;    ///< another whole frame waits in the rest of the input
  bool broken = false;  ///< send the output, then disconnect
  FixedVector<std::uint8_t, kTurnBytes> output;
};

/// Answers the first whole frames of the input, at most kFramesPerTurn.
Turn turn_of(std::span<const std::uint8_t> input, const AnswerPdu& answer);

}  // namespace tripoint
