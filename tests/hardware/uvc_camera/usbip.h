// The half of the USB/IP protocol that vhci_hcd speaks once it holds the connection.
// Source: Linux, Documentation/usb/usbip_protocol.rst (USBIP_CMD_SUBMIT, USBIP_CMD_UNLINK and their answers).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "socket.h"

namespace tripoint::uvc {

using Bytes = std::vector<std::uint8_t>;

/// Status of an answer: negative errno, as the kernel means it.
enum class Status : std::int32_t { kDone = 0, kStalled = -32, kUnlinked = -104 };

/// The eight bytes of a USB control request, decoded (USB 2.0, 9.3).
struct Setup {
  std::uint8_t request_type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
};

struct IsoPacket {
  std::uint32_t offset = 0;
  std::uint32_t length = 0;
};

/// A transfer that the host asks for.
struct Submit {
  std::uint32_t sequence = 0;
  std::uint32_t endpoint = 0;
  Setup setup;                     ///< of endpoint 0
  Bytes sent;                      ///< by the host, for a transfer out
  std::vector<IsoPacket> packets;  ///< of an isochronous transfer
};

/// The host takes a transfer back.
struct Unlink {
  std::uint32_t sequence = 0;
  std::uint32_t victim = 0;
};

using Request = std::variant<Submit, Unlink>;

/// The next request; nothing when the connection is over or sent nonsense.
std::optional<Request> read_request(const Socket& connection);

Bytes answer_to_control(const Submit& submit, Status status, std::span<const std::uint8_t> data);
Bytes answer_to_unlink(const Unlink& unlink, Status status);
/// @param payloads  one for each packet asked for, back to back; `lengths` says how long each is (0: nothing was sent)
Bytes answer_to_iso(const Submit& submit, std::span<const std::uint8_t> payloads,
                    std::span<const std::uint32_t> lengths);

}  // namespace tripoint::uvc
