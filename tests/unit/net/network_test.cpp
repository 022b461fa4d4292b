#include "net/network.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

bool holds(const char* network, const char* address) {
  return contains(client_network_from(network).value(), client_address_from(address).value());
}

TEST(NetworkTest, HoldsTheAddressesOfItsPrefix) {
  EXPECT_TRUE(holds("192.168.4.0/22", "192.168.7.255"));
  EXPECT_FALSE(holds("192.168.4.0/22", "192.168.8.0"));
  EXPECT_TRUE(holds("fd00::/8", "fdff::1"));
  EXPECT_FALSE(holds("fd00::/8", "fe00::1"));
  EXPECT_TRUE(holds("0.0.0.0/0", "8.8.8.8"));
  EXPECT_FALSE(holds("0.0.0.0/0", "::1"));
}

TEST(NetworkTest, AnAddressAloneIsItself) {
  EXPECT_TRUE(holds("10.0.0.1", "10.0.0.1"));
  EXPECT_FALSE(holds("10.0.0.1", "10.0.0.2"));
  EXPECT_TRUE(holds("::1", "::1"));
}

TEST(NetworkTest, AMappedAddressIsItsIpv4Address) { EXPECT_TRUE(holds("10.0.0.0/8", "::ffff:10.1.2.3")); }

TEST(NetworkTest, WhatIsNotANetworkIsRefused) {
  for (const char* text : {"", "plc", "10.0.0", "10.0.0.0/", "10.0.0.0/x", "10.0.0.0/8x", "/8"}) {
    const auto network = client_network_from(text);
    ASSERT_FALSE(network) << text;
    EXPECT_EQ(network.error().code, ErrorCode::kMalformed) << text;
  }
  EXPECT_EQ(client_network_from("10.0.0.0/33").error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(client_network_from("::/129").error().code, ErrorCode::kOutOfRange);
}

}  // namespace
}  // namespace tripoint
