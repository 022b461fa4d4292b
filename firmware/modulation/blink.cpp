#include "modulation/blink.h"

namespace tripoint {

void Blink::take_seen(LitLeds lit) {
  may_be_ = may_be_.both(lit);
  ++seen_in_a_row_;
  note_slot(lit);
}

void Blink::take_dark(LitLeds lit) {
  may_be_ = may_be_.without(lit);
  ++times_out_;
  seen_in_a_row_ = 0;
  out_last_ = true;
  note_slot(lit);
}

void Blink::take_unclear(LitLeds lit) {
  if (may_be_.both(lit).empty()) out_last_ = false;
}

std::optional<std::size_t> Blink::led() const {
  const bool whole_code = slots_known_ == LitLeds::first(code_.slots().size());
  if (!whole_code || times_out_ < kTimesOut || !out_last_ || seen_in_a_row_ > kMostSeenInARow) return std::nullopt;
  return may_be_.only();
}

void Blink::note_slot(LitLeds lit) {
  for (std::size_t slot = 0; slot < code_.slots().size(); ++slot) {
    if (code_.slots()[slot] == lit) slots_known_.insert(slot);
  }
}

}  // namespace tripoint
