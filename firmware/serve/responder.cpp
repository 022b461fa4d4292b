#include "serve/responder.h"

#include "values/assert.h"

namespace tripoint {
namespace {

using Request = std::span<const std::uint8_t>;

enum Function : std::uint8_t {
  kReadHolding = 3,
  kReadInput = 4,
  kWriteSingle = 6,
  kWriteMultiple = 16,
  kReadAndWrite = 23,
  kEncapsulated = 43,
};

// Modbus Application Protocol V1.1b3: the largest quantities of functions 3 and 4, 16, and 23 (write).
constexpr unsigned kMostRead = 125;
constexpr unsigned kMostWritten = 123;
constexpr unsigned kMostWrittenWithRead = 121;

constexpr std::uint16_t kCommand = registers::command::kFirst;

bool inside(unsigned address, unsigned count, unsigned first, unsigned length) {
  return address >= first && address + count <= first + length;
}

bool readable(unsigned address, unsigned count) {
  return inside(address, count, 0, registers::kImageLength) || inside(address, count, kCommand, 1) ||
         inside(address, count, registers::kMirrorAt, registers::kImageLength);
}

bool writable(unsigned address, unsigned count, const Asker& asker) {
  return asker.may_command && inside(address, count, kCommand, 1);
}

Pdu refused(Request request, ModbusException exception) { return exception_answer(request[0], exception); }

}  // namespace

Pdu Responder::answer(Request request, const Asker& asker) {
  TRIPOINT_ASSERT(!request.empty());
  switch (request[0]) {
    case kReadHolding:
    case kReadInput:
      return read(request, asker);
    case kWriteSingle:
      return write_single(request, asker);
    case kWriteMultiple:
      return write_multiple(request, asker);
    case kReadAndWrite:
      return read_and_write(request, asker);
    case kEncapsulated:
      return identification_answer(request, device_, publication_.newest(asker.now).state->identity.calibration_id);
    default:
      return refused(request, ModbusException::kIllegalFunction);
  }
}

Pdu Responder::read(Request request, const Asker& asker) {
  if (request.size() != 5) return refused(request, ModbusException::kIllegalValue);
  const std::uint16_t address = word_at(request, 1);
  const std::uint16_t count = word_at(request, 3);
  if (count < 1 || count > kMostRead) return refused(request, ModbusException::kIllegalValue);
  if (!readable(address, count)) return refused(request, ModbusException::kIllegalAddress);
  return words_at(request[0], address, count, asker);
}

Pdu Responder::write_single(Request request, const Asker& asker) {
  if (request.size() != 5) return refused(request, ModbusException::kIllegalValue);
  if (!writable(word_at(request, 1), 1, asker)) return refused(request, ModbusException::kIllegalAddress);
  desk_.write(word_at(request, 3), asker.now);
  Pdu echo;
  append_bytes(echo, request);
  return echo;
}

Pdu Responder::write_multiple(Request request, const Asker& asker) {
  if (request.size() < 6) return refused(request, ModbusException::kIllegalValue);
  const std::uint16_t count = word_at(request, 3);
  const bool whole = request[5] == 2U * count && request.size() == 6U + 2U * count;
  if (count < 1 || count > kMostWritten || !whole) return refused(request, ModbusException::kIllegalValue);
  if (!writable(word_at(request, 1), count, asker)) return refused(request, ModbusException::kIllegalAddress);
  desk_.write(word_at(request, 6), asker.now);
  Pdu echo;
  append_bytes(echo, request.first(5));
  return echo;
}

Pdu Responder::read_and_write(Request request, const Asker& asker) {
  if (request.size() < 10) return refused(request, ModbusException::kIllegalValue);
  const std::uint16_t address = word_at(request, 1);
  const std::uint16_t count = word_at(request, 3);
  const std::uint16_t written = word_at(request, 7);
  const bool whole = request[9] == 2U * written && request.size() == 10U + 2U * written;
  const bool permitted = count >= 1 && count <= kMostRead && written >= 1 && written <= kMostWrittenWithRead;
  if (!whole || !permitted) return refused(request, ModbusException::kIllegalValue);
  if (!readable(address, count) || !writable(word_at(request, 5), written, asker)) {
    return refused(request, ModbusException::kIllegalAddress);
  }
  desk_.write(word_at(request, 10), asker.now);
  return words_at(request[0], address, count, asker);
}

Pdu Responder::words_at(std::uint8_t function, std::uint16_t address, std::uint16_t count, const Asker& asker) {
  Pdu answer;
  answer.push_back(function);
  answer.push_back(static_cast<std::uint8_t>(2 * count));
  if (address == kCommand) {
    append_word(answer, desk_.word());
    return answer;
  }
  const Edition edition = publication_.newest(asker.now);
  const RegisterImage image =
      image_at(edition, ServiceState{asker.clients, asker.warnings, desk_.status(edition.latch)}, asker.now);
  const bool mirrored = address >= registers::kMirrorAt;
  const std::size_t first = mirrored ? address - std::size_t{registers::kMirrorAt} : address;
  for (std::size_t i = first; i < first + count; ++i) append_word(answer, image[mirrored ? kMirrorOrder[i] : i]);
  return answer;
}

}  // namespace tripoint
