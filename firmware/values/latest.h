// The newest value wins: how a writer hands its last word to readers in other threads.
#pragma once

#include <mutex>
#include <utility>

namespace tripoint {

/// Holds one value; a reader always gets a whole one. The lock is held for one copy only.
template <typename T>
class Latest {
 public:
  Latest() = default;
  explicit Latest(T value) : value_(std::move(value)) {}

  void put(T value) {
    std::scoped_lock lock(mutex_);
    value_ = std::move(value);
  }
  T get() const {
    std::scoped_lock lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  T value_{};
};

}  // namespace tripoint
