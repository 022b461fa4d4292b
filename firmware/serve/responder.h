// From request to answer: the rules of docs/reference/registers.md, without sockets.
#pragma once

#include <cstdint>
#include <span>

#include "serve/command.h"
#include "serve/device_identification.h"
#include "serve/image.h"
#include "serve/pdu.h"
#include "serve/publication.h"
#include "values/time.h"

namespace tripoint {

/// Who asks, when, and what the server knows at that moment.
struct Asker {
  TimePoint now{};
  bool may_command = false;  ///< named in modbus.command_clients
  std::uint16_t clients = 0;
  Warnings warnings;
};

/// Answers every request from one image. Used by one thread.
class Responder {
 public:
  Responder(Publication& publication, DeviceIdentification device)
      : publication_(publication), desk_(publication), device_(std::move(device)) {}

  /// @param request a PDU: function code and data, at least one byte
  /// @return the answering PDU; an exception for whatever the map refuses, and then nothing has changed
  Pdu answer(std::span<const std::uint8_t> request, const Asker& asker);

 private:
  Pdu read(std::span<const std::uint8_t> request, const Asker& asker);
  Pdu write_single(std::span<const std::uint8_t> request, const Asker& asker);
  Pdu write_multiple(std::span<const std::uint8_t> request, const Asker& asker);
  Pdu read_and_write(std::span<const std::uint8_t> request, const Asker& asker);
  Pdu words_at(std::uint8_t function, std::uint16_t address, std::uint16_t count, const Asker& asker);

  Publication& publication_;
  CommandDesk desk_;
  DeviceIdentification device_;
};

}  // namespace tripoint
