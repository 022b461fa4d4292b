#include "app/cameras_command.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "devices/camera_finder.h"
#include "devices/v4l2_driver.h"

namespace tripoint {
namespace {

void print_json(const std::vector<FoundCamera>& found) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FoundCamera& camera : found) {
    list.push_back({{"port", camera.port},
                    {"serial", camera.serial},
                    {"device", camera.node.string()},
                    {"vendor", camera.vendor},
                    {"product", camera.product},
                    {"formats", camera.formats}});
  }
  fmt::print("{}\n", list.dump());
}

void print_table(const std::vector<FoundCamera>& found) {
  fmt::print("{:<10} {:<20} {:<14} {}\n", "port", "serial", "device", "camera");
  for (const FoundCamera& camera : found) {
    fmt::print("{:<10} {:<20} {:<14} {} {}\n", camera.port.empty() ? "-" : camera.port,
               camera.serial.empty() ? "-" : camera.serial, camera.node.string(), camera.vendor, camera.product);
    for (const std::string& format : camera.formats) fmt::print("{:<46}  {}\n", "", format);
  }
}

}  // namespace

int cameras_command(bool json) {
  KernelV4l2Driver driver;
  const std::vector<FoundCamera> found = cameras(driver);
  if (json) {
    print_json(found);
  } else if (!found.empty()) {
    print_table(found);
  }
  if (!found.empty()) return number(ExitCode::kWell);
  fmt::print(stderr, "tripointd: no camera found; is one plugged in, and may this user open /dev/video*?\n");
  return number(ExitCode::kDeviceMissing);
}

}  // namespace tripoint
