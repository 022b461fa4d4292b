// The command word, holding register 1000: a handshake that a client which writes cyclically cannot trip over.
#pragma once

#include <cstdint>
#include <optional>

#include "serve/image.h"
#include "serve/publication.h"
#include "values/time.h"

namespace tripoint {

/// Takes words and tells how the command they started stands. One for the whole unit, used by the Modbus thread.
class CommandDesk {
 public:
  explicit CommandDesk(Publication& publication) : publication_(publication) {}

  /// A word was written. It starts a command only when the word before it was 0, which after start means: written.
  void write(std::uint16_t word, TimePoint now);

  /// What register 1000 reads.
  [[nodiscard]] std::uint16_t word() const { return word_; }

  /// Registers 40 to 43. The outcome of a latch is found in the latch that the answer is made with.
  [[nodiscard]] CommandStatus status(const Latch& latch) const;

 private:
  CommandStatus started(std::uint16_t word, TimePoint now);

  Publication& publication_;
  std::uint16_t word_ = 0;
  bool armed_ = false;  ///< the last word was a 0 that a client wrote
  CommandStatus status_;
  std::optional<std::uint32_t> latch_number_;  ///< of the latch that status_ speaks of
};

}  // namespace tripoint
