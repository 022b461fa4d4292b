#include "serve/publication.h"

#include <utility>

namespace tripoint {

Publication::Publication(UnitState first) : state_(std::make_shared<const UnitState>(std::move(first))) {}

void Publication::publish(UnitState state, TimePoint now) {
  Warnings warnings = state.warnings;
  if (state.newest) warnings.insert(state.newest->measurement.warnings);
  auto next = std::make_shared<const UnitState>(std::move(state));
  std::scoped_lock lock(mutex_);
  warnings_.take(warnings, now);
  latch_ = filled(expired(latch_, now), *next);
  state_.swap(next);
}

Edition Publication::newest(TimePoint now) {
  std::scoped_lock lock(mutex_);
  latch_ = expired(latch_, now);
  return Edition{state_, latch_, warnings_.held(now)};
}

std::uint32_t Publication::request_latch(TimePoint at) {
  std::scoped_lock lock(mutex_);
  latch_ = requested(latch_, at);
  return latch_.number;
}

}  // namespace tripoint
