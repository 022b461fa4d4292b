// What the kernel does for a camera: four system calls and the meaning of its stamps, so that every error path can be
// played in a test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "devices/exposure_stamp.h"
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
  /// What the stamps of its frames stand for, as long as a stream lasts.
  [[nodiscard]] virtual StampPoint stamp_point() const = 0;
};

/// The running kernel.
class KernelV4l2Driver final : public V4l2Driver {
 public:
  /// @param sys where the system shows its modules; a test has its own
  explicit KernelV4l2Driver(std::filesystem::path sys = "/sys") : sys_(std::move(sys)) {}

  int open(const std::filesystem::path& node) override;
  int control(int fd, unsigned long request, void* argument) override;
  int wait(int fd, Duration limit) override;
  void* map(int fd, std::size_t length, std::int64_t offset) override;
  /// kStartOfExposure when uvcvideo was told to stamp by the cameras' own clocks (its parameter hwtimestamps).
  [[nodiscard]] StampPoint stamp_point() const override;

 private:
  std::filesystem::path sys_;
};

}  // namespace tripoint
