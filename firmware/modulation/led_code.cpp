#include "modulation/led_code.h"

#include <bit>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr std::uint64_t kRound = 5;  // all, slot, all, all, slot

/// Ways to choose half of the slots, rounded down.
std::size_t codes_of(std::size_t slots) {
  std::size_t ways = 1;
  for (std::size_t i = 1; i <= slots / 2; ++i) ways = ways * (slots - slots / 2 + i) / i;
  return ways;
}

std::size_t slots_for(std::size_t leds) {
  std::size_t slots = 1;
  while (codes_of(slots) < leds) ++slots;
  return slots;
}

}  // namespace

LedCode::LedCode(std::size_t leds) : all_(LitLeds::first(leds)) {
  TRIPOINT_ASSERT(leds >= 1 && leds <= kMaxTargetPoints);
  const std::size_t slots = slots_for(leds);
  for (std::size_t slot = 0; slot < slots; ++slot) slots_.push_back(LitLeds{});
  std::uint32_t code = 0;
  for (std::size_t led = 0; led < leds; ++code) {
    if (static_cast<std::size_t>(std::popcount(code)) != slots / 2) continue;
    for (std::size_t slot = 0; slot < slots; ++slot) {
      if (((code >> slot) & 1U) != 0) slots_[slot].insert(led);
    }
    ++led;
  }
}

LitLeds LedCode::lit_in(std::uint64_t step) const {
  const std::uint64_t in_round = step % kRound;
  if (in_round != 1 && in_round != 4) return all_;
  const std::uint64_t slot = 2 * (step / kRound) + (in_round == 4 ? 1 : 0);
  return slots_[slot % slots_.size()];
}

}  // namespace tripoint
