#include "capture/repeat_check.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace tripoint {
namespace {

/// Independent chains, so that the multiplications overlap. Each step is a bijection of the chain's state.
class Hash {
 public:
  void add(std::span<const std::uint8_t> row) {
    std::size_t at = 0;
    for (; at + kBlock_bytes <= row.size(); at += kBlock_bytes) add_block(row.data() + at);
    if (at == row.size()) return;
    std::array<std::uint8_t, kBlock_bytes> padded{};
    std::memcpy(padded.data(), row.data() + at, row.size() - at);
    add_block(padded.data());
  }
  /// @return never 0, which stands for no picture
  [[nodiscard]] std::uint64_t value(ImageSize size) const {
    std::uint64_t state = static_cast<std::uint64_t>(size.width_px) << 32U | static_cast<std::uint32_t>(size.height_px);
    for (const std::uint64_t chain : chains_) mix(state, chain);
    return std::max<std::uint64_t>(state, 1);
  }

 private:
  static constexpr std::size_t kBlock_bytes = 64;

  void add_block(const std::uint8_t* block) {
    std::array<std::uint64_t, kBlock_bytes / sizeof(std::uint64_t)> words{};
    std::memcpy(words.data(), block, kBlock_bytes);
    for (std::size_t i = 0; i < words.size(); ++i) mix(chains_[i], words[i]);
  }
  static void mix(std::uint64_t& state, std::uint64_t value) {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio, odd
    state = (state ^ value) * kGolden;
    state ^= state >> 32U;
  }

  std::array<std::uint64_t, kBlock_bytes / sizeof(std::uint64_t)> chains_{1, 2, 3, 4, 5, 6, 7, 8};
};

std::uint64_t hash_of(const Picture& picture) {
  const std::size_t row_bytes = static_cast<std::size_t>(picture.size.width_px) * picture.luma.step_bytes;
  Hash hash;
  for (int y = 0; y < picture.size.height_px; ++y) {
    hash.add({picture.luma.row(y), row_bytes});
  }
  return hash.value(picture.size);
}

}  // namespace

bool RepeatCheck::repeats(const Picture& picture) { return remember(hash_of(picture)); }

bool RepeatCheck::repeats(std::span<const std::uint8_t> coded, ImageSize size) {
  Hash hash;
  hash.add(coded);
  return remember(hash.value(size));
}

bool RepeatCheck::remember(std::uint64_t hash) {
  auto* const found = std::ranges::find(seen_, hash);
  const bool repeated = found != seen_.end();
  std::rotate(seen_.begin(), repeated ? found : seen_.end() - 1, repeated ? found + 1 : seen_.end());
  seen_.front() = hash;
  return repeated;
}

}  // namespace tripoint
