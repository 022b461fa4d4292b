// The whole register image at the moment of an answer: docs/reference/registers.md, from 0 to 999.
#pragma once

#include <cstdint>

#include "serve/publication.h"
#include "serve/register_image.h"
#include "values/time.h"

namespace tripoint {

/// Registers 40 to 43.
struct CommandStatus {
  std::uint16_t echo = 0;
  registers::CommandState state = registers::CommandState::kIdle;
  registers::CommandResult result = registers::CommandResult::kDone;
  std::uint16_t detail = 0;
};

/// What only the server knows.
struct ServiceState {
  std::uint16_t clients = 0;
  Warnings warnings;
  CommandStatus command;
};

/// Age, staleness and validity are decided here, at `now`, whatever the edition says. Unknown is never 0.
RegisterImage image_at(const Edition& edition, const ServiceState& service, TimePoint now);

}  // namespace tripoint
