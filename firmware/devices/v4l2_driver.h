// The four system calls through which a camera is reached, so that every error path can be played in a test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "values/time.h"

namespace tripoint {

/// Numbers below zero are -errno. What open() and map() return is closed and unmapped by its owner.
class V4l2Driver {
 public:
  V4l2Driver() = default;
  V4l2Driver(const V4l2Driver&) = delete;
  V4l2Driver& operator=(const V4l2Driver&) = delete;
  virtual ~V4l2Driver() = default;

  /// Not blocking. @return a descriptor or -errno
  virtual int open(const std::filesystem::path& node) = 0;
  /// ioctl. @return 0 or -errno; never -EINTR
  virtual int control(int fd, unsigned long request, void* argument) = 0;
  /// poll for a frame. @return poll's revents, 0 when `limit` passed, or -errno
  virtual int wait(int fd, Duration limit) = 0;
  /// @return shared memory for reading, or null
  virtual void* map(int fd, std::size_t length, std::int64_t offset) = 0;
};

/// The running kernel.
class KernelV4l2Driver final : public V4l2Driver {
 public:
  int open(const std::filesystem::path& node) override;
  int control(int fd, unsigned long request, void* argument) override;
  int wait(int fd, Duration limit) override;
  void* map(int fd, std::size_t length, std::int64_t offset) override;
};

}  // namespace tripoint
