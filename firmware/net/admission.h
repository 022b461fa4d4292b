// Who gets a connection when they are all taken.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "net/network.h"
#include "values/time.h"

namespace tripoint {

/// A connection that exists.
struct Present {
  ClientAddress address;
  TimePoint last_heard{};  ///< of its last whole request, or of its arrival
  bool has_asked = false;  ///< a whole request, ever
};

struct Admission {
  bool admitted = false;
  std::optional<std::size_t> displaced;  ///< index of the connection that must go for it
};

/// When full, a newcomer from the address that holds most is refused; any other takes the place of that address's
/// longest silent one (of the longest silent of all such addresses, when several hold most). One that never asked has
/// been silent for longer than any that did: strangers who only connect do not drive out a client that polls.
Admission admission_of(const ClientAddress& newcomer, std::span<const Present> present, std::size_t most);

}  // namespace tripoint
