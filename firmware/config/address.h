// Whether a text is a numeric address or network, without any socket.
#pragma once

#include <string>

namespace tripoint {

/// Numeric IPv4 or IPv6.
bool is_address(const std::string& text);

/// An address, or one followed by "/n" with n up to its number of bits.
bool is_address_or_network(const std::string& text);

}  // namespace tripoint
