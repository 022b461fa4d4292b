#include "app/version.h"

#include <fmt/core.h>

namespace tripoint {

std::string version_text() { return fmt::format("{}.{}.{}", kVersion.major, kVersion.minor, kVersion.patch); }

DeviceIdentification device_identification() {
  DeviceIdentification device;
  device.version = version_text();
  return device;
}

}  // namespace tripoint
