// Seeded draws that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/random_key.h"

namespace tripoint {

/// What a value is drawn from, evenly in its logarithm where it spans scales.
struct Range {
  double low = 0.0;
  double high = 1.0;
};

/// A sequence of draws from a seed; another topic is another sequence, so that one part of a scene does not change
/// because another part draws more.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t topic) : key_(mixed(mixed(seed) ^ topic)) {}

  double even(double low, double high) { return low + (high - low) * unit(); }
  double even(const Range& range) { return even(range.low, range.high); }
  /// Evenly in the logarithm; both limits above 0, or equal.
  double scaled(const Range& range);
  double normal() { return normal_from(next()); }
  bool chance(double probability) { return unit() < probability; }
  /// 0 up to count - 1.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(unit() * static_cast<double>(count)); }

 private:
  std::uint64_t next() { return mixed(key_ + count_++); }
  double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace tripoint
