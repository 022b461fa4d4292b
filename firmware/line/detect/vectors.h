// Sixteen bytes at a time, in the compilers' own vector types: the same source for x86 and ARM.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace tripoint {

static_assert(std::endian::native == std::endian::little, "bytes are picked out of words");

using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
using Bytes8 = std::uint8_t __attribute__((vector_size(8)));
using Bytes4 = std::uint8_t __attribute__((vector_size(4)));
using Shorts4 = std::int16_t __attribute__((vector_size(8)));
using Shorts8 = std::uint16_t __attribute__((vector_size(16)));
using Words4 = std::uint32_t __attribute__((vector_size(16)));
using Longs2 = std::uint64_t __attribute__((vector_size(16)));
using Ints4 = std::int32_t __attribute__((vector_size(16)));
using Floats4 = float __attribute__((vector_size(16)));

template <typename Vector>
Vector loaded(const void* from) {
  Vector value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
template <typename Vector>
void store(void* to, Vector value) {
  std::memcpy(to, &value, sizeof value);
}
/// The low byte of each.
inline Bytes8 narrowed(Shorts8 v) {
  const auto bytes = reinterpret_cast<Bytes16>(v);
  return __builtin_shufflevector(bytes, bytes, 0, 2, 4, 6, 8, 10, 12, 14);
}
/// By way of integers, for which there are instructions.
template <typename Integers>
Floats4 floats_of(Integers v) {
  return __builtin_convertvector(__builtin_convertvector(v, Ints4), Floats4);
}
template <typename Vector>
Vector larger(Vector a, Vector b) {
  return a > b ? a : b;
}
/// a - b, but not below 0.
inline Bytes16 minus(Bytes16 a, Bytes16 b) { return larger(a, b) - b; }
inline bool any(Bytes16 mask) {
  const auto halves = reinterpret_cast<Longs2>(mask);
  return (halves[0] | halves[1]) != 0;
}
inline Bytes16 all_of(int value) { return Bytes16{} + static_cast<std::uint8_t>(value); }

}  // namespace tripoint
