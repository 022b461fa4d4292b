#include "devices/camera_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>
#include <tuple>

#include "devices/v4l2_device.h"
#include "devices/v4l2_format.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

constexpr int kMostParents = 32;  // folders above a device in sysfs

/// First line of a file of sysfs; "" when it is absent.
std::string attribute(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// The USB device above a video node: the first folder on the way up that has a vendor's id.
std::optional<fs::path> usb_device_of(const fs::path& node_in_sys) {
  std::error_code error;
  fs::path folder = fs::canonical(node_in_sys / "device", error);
  if (error) return std::nullopt;
  for (int level = 0; level < kMostParents && folder.has_relative_path(); ++level, folder = folder.parent_path()) {
    if (fs::exists(folder / "idVendor", error)) return folder;
  }
  return std::nullopt;
}

std::string first_known(const std::string& text, const fs::path& otherwise) {
  return text.empty() ? attribute(otherwise) : text;
}

/// Nothing for a node that delivers no pictures. A node that cannot be opened is kept: index 0 is a device's pictures.
std::optional<FoundCamera> camera_at(V4l2Driver& driver, const fs::path& node_in_sys, const fs::path& dev) {
  FoundCamera camera;
  camera.node = dev / node_in_sys.filename();
  const Result<V4l2Device> device = V4l2Device::open(driver, camera.node, camera.node.string());
  if (device ? !captures(*device).value_or(false) : attribute(node_in_sys / "index") != "0") return std::nullopt;
  if (device) camera.formats = formats_offered(*device);
  camera.product = attribute(node_in_sys / "name");
  const std::optional<fs::path> usb = usb_device_of(node_in_sys);
  if (!usb) return camera;
  camera.port = usb->filename().string();
  camera.serial = attribute(*usb / "serial");
  camera.vendor = first_known(attribute(*usb / "manufacturer"), *usb / "idVendor");
  camera.product = first_known(attribute(*usb / "product"), *usb / "idProduct");
  return camera;
}

bool same_node(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || fs::equivalent(a, b, error);
}

bool fits(const FoundCamera& camera, const CameraWanted& wanted) {
  return (wanted.port.empty() || camera.port == wanted.port) &&
         (wanted.serial.empty() || camera.serial == wanted.serial) &&
         (wanted.device.empty() || same_node(camera.node, wanted.device));
}

std::string description(const FoundCamera& camera) {
  return fmt::format("{} (port {}, serial {}, {})", camera.node.string(), camera.port.empty() ? "none" : camera.port,
                     camera.serial.empty() ? "none" : camera.serial, camera.product);
}

std::string description(const CameraWanted& wanted) {
  std::vector<std::string> parts;
  if (!wanted.port.empty()) parts.push_back("port " + wanted.port);
  if (!wanted.serial.empty()) parts.push_back("serial " + wanted.serial);
  if (!wanted.device.empty()) parts.push_back(wanted.device);
  return parts.empty() ? "any" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string descriptions(std::span<const FoundCamera> found) {
  std::vector<std::string> parts;
  for (const FoundCamera& camera : found) parts.push_back(description(camera));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::vector<FoundCamera> cameras(V4l2Driver& driver, const DeviceRoots& roots) {
  std::vector<FoundCamera> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(roots.sys / "class" / "video4linux", error)) {
    if (!entry.path().filename().string().starts_with("video")) continue;
    std::optional<FoundCamera> camera = camera_at(driver, entry.path(), roots.dev);
    if (camera) found.push_back(std::move(*camera));
  }
  std::sort(found.begin(), found.end(), [](const FoundCamera& a, const FoundCamera& b) {
    return std::tie(a.port, a.node) < std::tie(b.port, b.node);
  });
  return found;
}

Result<FoundCamera> camera_that_fits(std::span<const FoundCamera> found, const CameraWanted& wanted,
                                     std::string_view what) {
  std::vector<FoundCamera> fitting;
  std::copy_if(found.begin(), found.end(), std::back_inserter(fitting),
               [&](const FoundCamera& camera) { return fits(camera, wanted); });
  if (fitting.size() == 1) return fitting.front();
  if (fitting.empty()) {
    return failure(
        ErrorCode::kDeviceMissing,
        fmt::format("{}: no camera with {}: check its cable, and its port and serial by `tripointd cameras`; "
                    "found: {}",
                    what, description(wanted), descriptions(found)));
  }
  return failure(ErrorCode::kDeviceMissing, fmt::format("{}: {} cameras with {}: {}; name the port", what,
                                                        fitting.size(), description(wanted), descriptions(fitting)));
}

}  // namespace tripoint
