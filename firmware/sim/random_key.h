// Randomness without state: the same key always gives the same value.
#pragma once

#include <cstdint>

namespace tripoint {

/// Spreads the bits of a key.
/// Source: Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators".
constexpr std::uint64_t mixed(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15ULL;
  key = (key ^ (key >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  key = (key ^ (key >> 27U)) * 0x94D049BB133111EBULL;
  return key ^ (key >> 31U);
}

/// A normal value of mean 0 and variance 1 (Box & Muller 1958).
double normal_from(std::uint64_t key);

}  // namespace tripoint
