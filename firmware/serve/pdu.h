// A Modbus protocol data unit, and how words are read from and put into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "values/fixed_vector.h"

namespace tripoint {

inline constexpr std::size_t kLongestPdu = 253;  ///< bytes, Modbus Application Protocol V1.1b3, 4.1

/// Function code and data, without unit id.
using Pdu = FixedVector<std::uint8_t, kLongestPdu>;

/// Modbus exception codes that this server uses.
enum class ModbusException : std::uint8_t {
  kIllegalFunction = 1,
  kIllegalAddress = 2,
  kIllegalValue = 3,
};

inline std::uint16_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] << 8U | bytes[at + 1]);
}

inline void append_word(Pdu& pdu, std::uint16_t word) {
  pdu.push_back(static_cast<std::uint8_t>(word >> 8U));
  pdu.push_back(static_cast<std::uint8_t>(word & 0xFFU));
}

inline void append_bytes(Pdu& pdu, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) pdu.push_back(byte);
}

inline Pdu exception_answer(std::uint8_t function, ModbusException exception) {
  Pdu pdu;
  pdu.push_back(static_cast<std::uint8_t>(function | 0x80U));
  pdu.push_back(static_cast<std::uint8_t>(exception));
  return pdu;
}

}  // namespace tripoint
