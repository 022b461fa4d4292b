// A vector with a bound and without allocation.
#pragma once

#include <array>
#include <cstddef>

#include "values/assert.h"

namespace tripoint {

/// Up to `N` values in place. T must be default constructible.
template <typename T, std::size_t N>
class FixedVector {
 public:
  using value_type = T;

  static constexpr std::size_t capacity() { return N; }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  [[nodiscard]] constexpr bool full() const { return size_ == N; }

  /// @return false, and nothing changed, when full: the caller decides what a full vector means
  [[nodiscard]] constexpr bool try_push_back(const T& value) {
    if (full()) return false;
    values_[size_++] = value;
    return true;
  }
  /// For callers that know there is room; no room is a bug.
  constexpr void push_back(const T& value) {
    TRIPOINT_ASSERT(!full());
    values_[size_++] = value;
  }
  /// The vector must not be empty.
  constexpr void pop_back() {
    TRIPOINT_ASSERT(!empty());
    --size_;
  }
  constexpr void clear() { size_ = 0; }
  constexpr void truncate(std::size_t size) {
    TRIPOINT_ASSERT(size <= size_);
    size_ = size;
  }

  constexpr T& operator[](std::size_t i) {
    TRIPOINT_ASSERT(i < size_);
    return values_[i];
  }
  constexpr const T& operator[](std::size_t i) const {
    TRIPOINT_ASSERT(i < size_);
    return values_[i];
  }
  [[nodiscard]] constexpr T& back() { return (*this)[size_ - 1]; }
  [[nodiscard]] constexpr const T& back() const { return (*this)[size_ - 1]; }
  [[nodiscard]] constexpr T* begin() { return values_.data(); }
  [[nodiscard]] constexpr T* end() { return values_.data() + size_; }
  [[nodiscard]] constexpr const T* begin() const { return values_.data(); }
  [[nodiscard]] constexpr const T* end() const { return values_.data() + size_; }

 private:
  std::array<T, N> values_{};
  std::size_t size_ = 0;
};

}  // namespace tripoint
