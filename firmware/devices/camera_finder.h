// The cameras of this machine, named by what does not change over a reboot: USB port and serial number.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "devices/v4l2_driver.h"
#include "values/result.h"

namespace tripoint {

struct FoundCamera {
  std::filesystem::path node;        ///< /dev/videoN; may change over a reboot
  std::string port;                  ///< USB port path such as 1-1.2; "" when it is not on USB
  std::string serial;                ///< "" when it has none
  std::string vendor;                ///< manufacturer, else the vendor's id
  std::string product;               ///< product name, else the product's id
  std::vector<std::string> formats;  ///< "YUYV 640x480 at 30, 15 Hz"; empty when it could not be opened
};

/// What a camera must be; "" = does not matter. All that is given must fit.
struct CameraWanted {
  std::string port = {};
  std::string serial = {};
  std::string device = {};  ///< a path of a node, symbolic links followed
};

/// Where the system shows its devices; a test has its own.
struct DeviceRoots {
  std::filesystem::path sys = "/sys";
  std::filesystem::path dev = "/dev";
};

/// Capture nodes only, sorted by port and node.
std::vector<FoundCamera> cameras(V4l2Driver& driver, const DeviceRoots& roots = {});

/// The one camera that fits.
///
/// @param what for the message: "camera left"
/// @return kDeviceMissing when none fits or several do; the message names what was found
Result<FoundCamera> camera_that_fits(std::span<const FoundCamera> found, const CameraWanted& wanted,
                                     std::string_view what);

}  // namespace tripoint
