#include "devices/v4l2_device.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tripoint {
namespace {

Error error_from(const std::string& name, int negative_errno, std::string_view what) {
  const int number = -negative_errno;
  const auto say = [&](ErrorCode code, std::string_view remedy) {
    return Error{code,
                 fmt::format("{}: cannot {}: {}; {}", name, what, std::generic_category().message(number), remedy)};
  };
  switch (number) {
    case ENODEV:
    case ENOENT:
    case ENXIO:
    case ESHUTDOWN:
      return say(ErrorCode::kDeviceMissing, "check plug and cable");
    case EBUSY:
      return say(ErrorCode::kDeviceBusy, "another program uses it: end that one (fuser names it)");
    case ENOSPC:
      return say(ErrorCode::kNoBandwidth, "give each camera a USB bus of its own, or ask for less");
    case EACCES:
    case EPERM:
      return say(ErrorCode::kDeviceFault, "the user must be in the group video");
    default:
      return say(ErrorCode::kDeviceFault, "see the kernel's log");
  }
}

}  // namespace

Result<V4l2Device> V4l2Device::open(V4l2Driver& driver, const std::filesystem::path& node, std::string name) {
  const int fd = driver.open(node);
  if (fd < 0) return tl::make_unexpected(error_from(name, fd, fmt::format("open {}", node.string())));
  return V4l2Device(driver, UniqueFd(fd), std::move(name));
}

Error V4l2Device::error(int negative_errno, std::string_view what) const {
  return error_from(name_, negative_errno, what);
}

}  // namespace tripoint
