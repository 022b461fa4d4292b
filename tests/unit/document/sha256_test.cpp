#include "document/sha256.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

// FIPS 180-4 example: "abc".
TEST(Sha256Test, TheStandardsExampleComesOut) {
  EXPECT_EQ(hex_from(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256Test, NothingHasTheKnownHash) {
  EXPECT_EQ(hex_from(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256Test, TheIdIsTheFirst32Bits) { EXPECT_EQ(id_from(sha256("abc")), 0xba7816bfU); }

TEST(Sha256Test, TheIdIsNeverZero) { EXPECT_EQ(id_from(Sha256{}), 1U); }

}  // namespace
}  // namespace tripoint
