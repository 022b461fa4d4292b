#include "config/address.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(AddressTest, NumericAddressesAreAddresses) {
  for (const char* text : {"127.0.0.1", "0.0.0.0", "255.255.255.255", "::", "fe80::1"})
    EXPECT_TRUE(is_address(text)) << text;
}

TEST(AddressTest, NamesAndHalfAddressesAreNone) {
  for (const char* text : {"", "plc", "1.2.3", "1.2.3.256", "1.2.3.4.5", "1.2.3.4/8"})
    EXPECT_FALSE(is_address(text)) << text;
}

TEST(AddressTest, ANetworkHasAPrefixUpToItsBits) {
  for (const char* text : {"10.0.0.0/0", "10.0.0.0/32", "fd00::/128", "10.0.0.1"}) {
    EXPECT_TRUE(is_address_or_network(text)) << text;
  }
  for (const char* text : {"10.0.0.0/33", "fd00::/129", "10.0.0.0/", "10.0.0.0/-1", "10.0.0.0/8x", "/8", "x/0"}) {
    EXPECT_FALSE(is_address_or_network(text)) << text;
  }
}

}  // namespace
}  // namespace tripoint
