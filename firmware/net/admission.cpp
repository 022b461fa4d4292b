#include "net/admission.h"

#include <algorithm>
#include <map>
#include <utility>

namespace tripoint {

Admission admission_of(const ClientAddress& newcomer, std::span<const Present> present, std::size_t most) {
  if (present.size() < most) return Admission{true, std::nullopt};
  std::map<ClientAddress, std::size_t> held;
  std::size_t largest = 0;
  for (const Present& one : present) largest = std::max(largest, ++held[one.address]);
  if (largest == 0 || held[newcomer] == largest) return Admission{};

  const auto heard = [](const Present& one) { return std::pair(one.has_asked, one.last_heard); };
  std::optional<std::size_t> silent;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (held[present[i].address] != largest) continue;
    if (!silent || heard(present[i]) < heard(present[*silent])) silent = i;
  }
  return Admission{true, silent};
}

}  // namespace tripoint
