#include "capture/repeat_check.h"

#include <array>
#include <cstddef>
#include <cstring>

namespace tripoint {
namespace {

constexpr std::size_t kLine_bytes = 64;     // a cache line: what one read costs
constexpr std::size_t kStride_bytes = 448;  // not a divisor of 640, 1280 or 2560: the sample walks across the columns

/// Four independent chains, so that the multiplications overlap. Each step is a bijection of the chain's state.
class Hash {
 public:
  void add_line(const std::uint8_t* line) {
    for (std::size_t word = 0; word < kLine_bytes / sizeof(std::uint64_t); ++word) {
      std::uint64_t value = 0;
      std::memcpy(&value, line + word * sizeof value, sizeof value);
      mix(chains_[word % chains_.size()], value);
    }
  }
  /// At most one line; shorter data is padded with zeros, so the caller adds the length too.
  void add_rest(std::span<const std::uint8_t> rest) {
    std::array<std::uint8_t, kLine_bytes> padded{};
    if (!rest.empty()) std::memcpy(padded.data(), rest.data(), rest.size());
    add_line(padded.data());
  }
  [[nodiscard]] std::uint64_t value(std::size_t length) const {
    std::uint64_t state = length;
    for (const std::uint64_t chain : chains_) mix(state, chain);
    return state;
  }

 private:
  static void mix(std::uint64_t& state, std::uint64_t value) {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio, odd
    state = (state ^ value) * kGolden;
    state ^= state >> 32U;
  }

  std::array<std::uint64_t, 4> chains_{1, 2, 3, 4};
};

std::uint64_t hash_of(std::span<const std::uint8_t> data, std::size_t stride_bytes) {
  Hash hash;
  std::size_t at = 0;
  for (; at + kLine_bytes <= data.size(); at += stride_bytes) hash.add_line(data.data() + at);
  if (at < data.size()) hash.add_rest(data.subspan(at));
  return hash.value(data.size());
}

}  // namespace

bool RepeatCheck::repeats(std::span<const std::uint8_t> data) {
  const std::uint64_t sample = hash_of(data, kStride_bytes);
  if (sample_ != sample) {
    sample_ = sample;
    whole_.reset();
    return false;
  }
  const std::uint64_t whole = hash_of(data, kLine_bytes);
  const bool repeated = whole_ == whole;
  whole_ = whole;
  return repeated;
}

}  // namespace tripoint
