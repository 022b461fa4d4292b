// The one queue of the line: bounded, every wait limited, the oldest gives way when it is full.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "values/assert.h"
#include "values/time.h"

namespace tripoint {

/// Many writers, one reader. When full, the oldest value is dropped and counted: in measuring, new beats old.
/// All storage is taken at construction.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : slots_(capacity) { TRIPOINT_ASSERT(capacity > 0); }

  void push(const T& value) {
    {
      std::scoped_lock lock(mutex_);
      if (size_ == slots_.size()) {
        first_ = (first_ + 1) % slots_.size();
        --size_;
        ++dropped_;
      }
      slots_[(first_ + size_) % slots_.size()] = value;
      ++size_;
    }
    ready_.notify_one();
  }

  /// @return nothing when `limit` passed without a value
  std::optional<T> pop(Duration limit) {
    std::unique_lock lock(mutex_);
    if (!ready_.wait_for(lock, limit, [this] { return size_ > 0; })) return std::nullopt;
    T value = slots_[first_];
    first_ = (first_ + 1) % slots_.size();
    --size_;
    return value;
  }

  [[nodiscard]] std::uint64_t dropped() const {
    std::scoped_lock lock(mutex_);
    return dropped_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable ready_;
  std::vector<T> slots_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace tripoint
