#include "serve/device_identification.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "contract/registers.h"

namespace tripoint {
namespace {

constexpr std::uint8_t kMei = 14;
constexpr std::uint8_t kConformity = 0x83;  // extended identification, stream and individual access
constexpr std::uint8_t kIndividual = 4;     // read device id code: one object

struct Object {
  std::uint8_t id;
  std::string text;
};

std::array<Object, 9> objects_of(const DeviceIdentification& device, std::uint32_t calibration_id) {
  return {Object{0, device.vendor},
          Object{1, device.product_code},
          Object{2, device.version},
          Object{3, device.url},
          Object{4, device.product},
          Object{5, device.model},
          Object{6, device.application},
          Object{0x80, fmt::format("{}.{}", registers::kMajor, registers::kMinor)},
          Object{0x81, fmt::format("{:08x}", calibration_id)}};
}

/// The last object of a category: 1 basic, 2 regular, 3 extended.
std::uint8_t last_object(std::uint8_t code) {
  constexpr std::array<std::uint8_t, 3> kLast{2, 6, 0x81};
  return kLast[code - 1U];
}

void append_object(Pdu& pdu, const Object& object) {
  const std::size_t length = std::min(object.text.size(), DeviceIdentification::kLongest);
  pdu.push_back(object.id);
  pdu.push_back(static_cast<std::uint8_t>(length));
  for (std::size_t i = 0; i < length; ++i) pdu.push_back(static_cast<std::uint8_t>(object.text[i]));
}

}  // namespace

Pdu identification_answer(std::span<const std::uint8_t> request, const DeviceIdentification& device,
                          std::uint32_t calibration_id) {
  const std::uint8_t function = request[0];
  if (request.size() < 2) return exception_answer(function, ModbusException::kIllegalValue);
  if (request[1] != kMei) return exception_answer(function, ModbusException::kIllegalFunction);
  if (request.size() != 4) return exception_answer(function, ModbusException::kIllegalValue);
  const std::uint8_t code = request[2];
  if (code < 1 || code > kIndividual) return exception_answer(function, ModbusException::kIllegalValue);

  const std::array<Object, 9> objects = objects_of(device, calibration_id);
  const bool known = std::any_of(objects.begin(), objects.end(), [&](const Object& o) { return o.id == request[3]; });
  if (code == kIndividual && !known) return exception_answer(function, ModbusException::kIllegalAddress);
  // A stream that starts at an object which does not exist, or lies beyond the category, starts at the first one.
  const std::uint8_t last = code == kIndividual ? request[3] : last_object(code);
  const std::uint8_t first = known && request[3] <= last ? request[3] : std::uint8_t{0};

  Pdu answer;
  for (const std::uint8_t byte : {function, kMei, code, kConformity, std::uint8_t{0}, std::uint8_t{0}}) {
    answer.push_back(byte);
  }
  std::uint8_t count = 0;
  answer.push_back(count);
  for (const Object& object : objects) {
    if (object.id < first || object.id > last) continue;
    append_object(answer, object);
    ++count;
  }
  answer[6] = count;
  return answer;
}

}  // namespace tripoint
