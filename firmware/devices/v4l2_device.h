// An open video node, and what its errors mean.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "devices/unique_fd.h"
#include "devices/v4l2_driver.h"
#include "values/result.h"

namespace tripoint {

class V4l2Device {
 public:
  /// @param driver must outlive the device
  /// @param name   begins every message: "left (usb 1-1, LEFT-001)"
  /// @return errors as `error` gives them
  static Result<V4l2Device> open(V4l2Driver& driver, const std::filesystem::path& node, std::string name);

  /// @param what the attempt, for the message: "start streaming"
  /// @return errors as `error` gives them
  template <typename T>
  Result<void> control(unsigned long request, T& argument, std::string_view what) const {
    const int result = try_control(request, argument);
    if (result < 0) return tl::make_unexpected(error(result, what));
    return {};
  }
  /// @return 0 or -errno
  template <typename T>
  int try_control(unsigned long request, T& argument) const {
    return driver_->control(fd_.get(), request, &argument);
  }
  [[nodiscard]] int wait(Duration limit) const { return driver_->wait(fd_.get(), limit); }
  [[nodiscard]] void* map(std::size_t length, std::int64_t offset) const {
    return driver_->map(fd_.get(), length, offset);
  }

  /// kDeviceMissing for ENODEV, ENOENT, ENXIO, ESHUTDOWN; kDeviceBusy for EBUSY; kNoBandwidth for ENOSPC; else
  /// kDeviceFault.
  [[nodiscard]] Error error(int negative_errno, std::string_view what) const;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  V4l2Device(V4l2Driver& driver, UniqueFd fd, std::string name)
      : driver_(&driver), fd_(std::move(fd)), name_(std::move(name)) {}

  V4l2Driver* driver_;
  UniqueFd fd_;
  std::string name_;
};

}  // namespace tripoint
