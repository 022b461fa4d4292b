// Addresses and networks of clients, for the allow-list, the command clients and counting.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>
#include <vector>

#include "values/result.h"

namespace tripoint {

/// 16 bytes; an IPv4 address a.b.c.d is ::ffff:a.b.c.d.
struct ClientAddress {
  std::array<std::uint8_t, 16> bytes{};
  friend auto operator<=>(const ClientAddress&, const ClientAddress&) = default;
};

/// All addresses whose first `prefix_bits` are those of `address`.
struct ClientNetwork {
  ClientAddress address;
  unsigned prefix_bits = 128;
};

/// @return kMalformed for anything but a numeric IPv4 or IPv6 address
Result<ClientAddress> client_address_from(std::string_view text);

/// "192.168.0.0/24", "fd00::/8", or an address alone.
///
/// @return kMalformed, or kOutOfRange for a prefix longer than the address
Result<ClientNetwork> client_network_from(std::string_view text);

bool contains(const ClientNetwork& network, const ClientAddress& address);
bool any_contains(const std::vector<ClientNetwork>& networks, const ClientAddress& address);

}  // namespace tripoint
