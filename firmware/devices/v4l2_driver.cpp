#include "devices/v4l2_driver.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

namespace tripoint {

int KernelV4l2Driver::open(const std::filesystem::path& node) {
  const int fd = ::open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  return fd >= 0 ? fd : -errno;
}

int KernelV4l2Driver::control(int fd, unsigned long request, void* argument) {
  int result = 0;
  do {
    result = ::ioctl(fd, request, argument);
  } while (result < 0 && errno == EINTR);
  return result < 0 ? -errno : 0;
}

int KernelV4l2Driver::wait(int fd, Duration limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd asked{.fd = fd, .events = POLLIN, .revents = 0};
    const int ready = ::poll(&asked, 1, static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 60'000)));
    if (ready > 0) return asked.revents;
    if (ready == 0) return 0;
    if (errno != EINTR) return -errno;
  }
}

void* KernelV4l2Driver::map(int fd, std::size_t length, std::int64_t offset) {
  void* memory = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, fd, offset);
  return memory == MAP_FAILED ? nullptr : memory;
}

StampPoint KernelV4l2Driver::stamp_point() const {
  std::ifstream parameter(sys_ / "module/uvcvideo/parameters/hwtimestamps");
  int by_camera = 0;
  return parameter >> by_camera && by_camera != 0 ? StampPoint::kStartOfExposure : StampPoint::kFirstByte;
}

}  // namespace tripoint
