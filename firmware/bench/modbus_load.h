// Many Modbus clients in one thread, as a cell full of PLCs would poll: how long answers take, and whether they agree.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "values/result.h"

namespace tripoint::bench {

struct LoadPlan {
  std::uint16_t port = 1502;
  int clients = 64;
  std::chrono::microseconds period{20'000};  ///< of each client; 0: the next request follows the answer
  std::chrono::seconds duration{10};
  std::uint64_t most_answers = UINT64_MAX;
};

struct LoadResult {
  std::vector<float> times_ms;  ///< one for each answer, from the moment the request was due
  std::uint64_t torn = 0;       ///< answers that the check refused
  int lost = 0;                 ///< connections that ended early
};

/// Judges the 116 registers from 32 on.
using AnswerCheck = std::function<bool(std::span<const std::uint16_t>)>;

/// Sequence first and last are equal: what every client can check.
bool sequences_agree(std::span<const std::uint16_t> registers_from_32);

/// Polls FC 3, 32 to 147, at 127.0.0.1.
///
/// @return kDeviceMissing when nobody listens there
Result<LoadResult> load(const LoadPlan& plan, const AnswerCheck& check);

}  // namespace tripoint::bench
