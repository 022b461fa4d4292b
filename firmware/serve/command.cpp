#include "serve/command.h"

namespace tripoint {
namespace {

using registers::CommandResult;
using registers::CommandState;

constexpr unsigned kLatchCode = 1;

CommandStatus failed(std::uint16_t word, CommandResult why) {
  return CommandStatus{word, CommandState::kFailed, why, 0};
}

}  // namespace

void CommandDesk::write(std::uint16_t word, TimePoint now) {
  const bool starts = armed_ && word != 0;
  word_ = word;
  armed_ = word == 0;
  if (word == 0) {
    status_ = CommandStatus{};
    latch_number_.reset();
  } else if (starts) {
    status_ = started(word, now);
  }
}

CommandStatus CommandDesk::started(std::uint16_t word, TimePoint now) {
  const unsigned code = word >> 8U;
  const unsigned token = word & 0xFFU;
  if (code != kLatchCode || token == 0) return failed(word, CommandResult::kUnknownCode);
  if (publication_.newest(now).latch.outcome == LatchOutcome::kWaiting) return failed(word, CommandResult::kBusy);
  latch_number_ = publication_.request_latch(now);
  return CommandStatus{word, CommandState::kBusy, CommandResult::kDone, 0};
}

CommandStatus CommandDesk::status(const Latch& latch) const {
  if (!latch_number_) return status_;
  // A trigger edge may have started a latch after ours: then ours is what the copy no longer holds.
  const bool ours = latch.number == *latch_number_;
  if (ours && latch.outcome == LatchOutcome::kWaiting) return status_;
  if (!ours || latch.copy == nullptr) return failed(status_.echo, CommandResult::kNoPoseInTime);
  return CommandStatus{status_.echo, CommandState::kDone, CommandResult::kDone,
                       static_cast<std::uint16_t>(latch.copy->published.measurement.sequence)};
}

}  // namespace tripoint
