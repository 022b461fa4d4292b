// Any bytes as what a Modbus client sends, in pieces: every answer is a whole frame that belongs to a request, and
// whatever the bytes say, the image stays readable.
//
// The first byte of the input chooses who asks (bit 0: a client that may command) and the size of the pieces.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "net/framing.h"
#include "serve/responder.h"
#include "values/assert.h"

namespace {

using namespace tripoint;

UnitState state() {
  UnitState unit;
  Measurement measurement;
  measurement.sequence = 7;
  measurement.exposed = time_from_ns(1'000'000'000);
  measurement.pose = TargetPose{};
  measurement.points.push_back(MeasuredPoint{});
  unit.newest = PublishedMeasurement{measurement, Duration{0}};
  unit.exposure_since_start = true;
  unit.pose_since_start = true;
  return unit;
}

/// The answer belongs to the request: its function, or its exception; the words it says it carries.
void check(std::span<const std::uint8_t> request, const Pdu& answer) {
  TRIPOINT_ASSERT(answer.size() >= 2);
  TRIPOINT_ASSERT((answer[0] & 0x7FU) == (request[0] & 0x7FU));
  const bool refused = answer[0] != request[0] || (request[0] & 0x80U) != 0;
  if (refused) TRIPOINT_ASSERT(answer.size() == 2 && answer[1] >= 1 && answer[1] <= 3);
  if (!refused && (request[0] == 3 || request[0] == 4)) TRIPOINT_ASSERT(answer.size() == 2U + answer[1]);
}

/// Every byte of the output lies in a whole frame.
void check_frames(const Turn& turn) {
  std::span<const std::uint8_t> rest(turn.output.begin(), turn.output.size());
  std::size_t frames = 0;
  while (!rest.empty()) {
    const Frame frame = first_frame(rest);
    TRIPOINT_ASSERT(frame.state == FrameState::kWhole);
    rest = rest.subspan(frame.length);
    ++frames;
  }
  TRIPOINT_ASSERT(frames == turn.requests);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const bool may_command = (data[0] & 1U) != 0;
  const std::size_t piece = 1U + (data[0] >> 1U);
  Publication publication(state());
  Responder responder(publication, DeviceIdentification{});
  TimePoint now = time_from_ns(1'000'000'000);
  const auto answer = [&](std::span<const std::uint8_t> request) {
    now += Duration{50'000'000};
    const Pdu pdu = responder.answer(request, Asker{now, may_command, 1, {}});
    check(request, pdu);
    return pdu;
  };
  std::vector<std::uint8_t> waiting;
  for (std::size_t at = 1; at < size; at += piece) {
    waiting.insert(waiting.end(), data + at, data + std::min(size, at + piece));
    Turn turn;
    do {
      turn = turn_of(waiting, answer);
      check_frames(turn);
      waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(turn.consumed));
    } while (turn.more);
    if (turn.broken) return 0;
    TRIPOINT_ASSERT(waiting.size() < kLongestFrame);  // what the connection can hold is enough
  }
  return 0;
}
