// Modbus function 43/14, read device identification: who made this, what it is, which versions.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "serve/pdu.h"

namespace tripoint {

/// Objects 0 to 6, 0x80 and 0x81; each is cut to kLongest bytes, so that all fit into one answer.
struct DeviceIdentification {
  static constexpr std::size_t kLongest = 24;

  std::string vendor = "Tripoint";
  std::string product_code = "TP";
  std::string version;
  std::string url;
  std::string product = "Tripoint";
  std::string model = "Stereo tracker";
  std::string application = "Position for robots";
};

/// @param request the PDU, function code included
/// @return the answer, or an exception: 01 for another MEI type, 02 for an unknown object, 03 for a malformed request
/// Source: Modbus Application Protocol V1.1b3, 6.21
Pdu identification_answer(std::span<const std::uint8_t> request, const DeviceIdentification& device,
                          std::uint32_t calibration_id);

}  // namespace tripoint
