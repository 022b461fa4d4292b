#include "net/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <charconv>
#include <string>

#include "net/asio_address.h"

namespace tripoint {
namespace {

constexpr unsigned kMappedBits = 96;  // of ::ffff:0:0/96, where IPv4 lives

Result<unsigned> prefix_from(std::string_view text, unsigned longest) {
  unsigned bits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return failure(ErrorCode::kMalformed, fmt::format("'/{}' is not a prefix length", text));
  }
  if (bits > longest) {
    return failure(ErrorCode::kOutOfRange, fmt::format("prefix {}: 0 to {}", text, longest));
  }
  return bits;
}

}  // namespace

ClientAddress client_address_of(const boost::asio::ip::address& address) {
  if (address.is_v6()) return ClientAddress{address.to_v6().to_bytes()};
  const auto four = address.to_v4().to_bytes();
  ClientAddress mapped;
  mapped.bytes[10] = mapped.bytes[11] = 0xFF;
  std::copy(four.begin(), four.end(), mapped.bytes.begin() + 12);
  return mapped;
}

Result<ClientAddress> client_address_from(std::string_view text) {
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(std::string(text), error);
  if (error) return failure(ErrorCode::kMalformed, fmt::format("'{}' is not a numeric address", text));
  return client_address_of(address);
}

Result<ClientNetwork> client_network_from(std::string_view text) {
  const std::size_t slash = text.find('/');
  const Result<ClientAddress> address = client_address_from(text.substr(0, slash));
  if (!address) return tl::make_unexpected(address.error());
  if (slash == std::string_view::npos) return ClientNetwork{*address};
  const bool four = text.substr(0, slash).find(':') == std::string_view::npos;
  const Result<unsigned> prefix = prefix_from(text.substr(slash + 1), four ? 32 : 128);
  if (!prefix) return tl::make_unexpected(prefix.error());
  return ClientNetwork{*address, *prefix + (four ? kMappedBits : 0)};
}

bool contains(const ClientNetwork& network, const ClientAddress& address) {
  for (unsigned bit = 0; bit < network.prefix_bits; ++bit) {
    const unsigned difference = network.address.bytes[bit / 8] ^ unsigned { address.bytes[bit / 8] };
    if ((difference >> (7 - bit % 8) & 1U) != 0) return false;
  }
  return true;
}

bool any_contains(const std::vector<ClientNetwork>& networks, const ClientAddress& address) {
  return std::any_of(networks.begin(), networks.end(), [&](const auto& network) { return contains(network, address); });
}

}  // namespace tripoint
