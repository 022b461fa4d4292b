// Which version this is, for registers, Modbus device identification and `tripointd version`.
#pragma once

#include "serve/device_identification.h"
#include "serve/unit_state.h"

namespace tripoint {

inline constexpr FirmwareVersion kVersion{
    .major = TRIPOINT_VERSION_MAJOR, .minor = TRIPOINT_VERSION_MINOR, .patch = TRIPOINT_VERSION_PATCH};

std::string version_text();
DeviceIdentification device_identification();

}  // namespace tripoint
