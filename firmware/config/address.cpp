#include "config/address.h"

#include <arpa/inet.h>

#include <array>
#include <charconv>

namespace tripoint {
namespace {

/// 32 or 128; 0 for anything that is no address.
int bits_of_address(const std::string& text) {
  std::array<unsigned char, 16> bytes{};
  if (::inet_pton(AF_INET, text.c_str(), bytes.data()) == 1) return 32;
  if (::inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1) return 128;
  return 0;
}

}  // namespace

bool is_address(const std::string& text) { return bits_of_address(text) > 0; }

bool is_address_or_network(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return is_address(text);
  const int bits = bits_of_address(text.substr(0, slash));
  int prefix = -1;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + slash + 1, end, prefix);
  return error == std::errc{} && stop == end && prefix >= 0 && prefix <= bits && bits > 0;
}

}  // namespace tripoint
