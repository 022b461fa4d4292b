// SHA-256, for identities and for noticing damage.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tripoint {

using Sha256 = std::array<std::uint8_t, 32>;

/// Source: FIPS 180-4.
Sha256 sha256(std::string_view bytes);

/// 64 lower-case digits.
std::string hex_from(const Sha256& hash);

/// The first 32 bits, big-endian; never 0, which stands for "none" in the registers.
std::uint32_t id_from(const Sha256& hash);

}  // namespace tripoint
