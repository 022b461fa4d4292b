#include "net/admission.h"

#include <gtest/gtest.h>

#include <vector>

namespace tripoint {
namespace {

ClientAddress address(const char* text) { return client_address_from(text).value(); }

std::vector<Present> present() {
  return {{address("10.0.0.1"), time_from_ns(5)},
          {address("10.0.0.2"), time_from_ns(1)},
          {address("10.0.0.1"), time_from_ns(3)}};
}

TEST(AdmissionTest, WhileThereIsRoomEveryoneIsAdmitted) {
  const Admission admission = admission_of(address("10.0.0.1"), present(), 4);
  EXPECT_TRUE(admission.admitted);
  EXPECT_FALSE(admission.displaced);
}

TEST(AdmissionTest, WhenFullTheAddressThatHoldsMostIsRefused) {
  EXPECT_FALSE(admission_of(address("10.0.0.1"), present(), 3).admitted);
}

TEST(AdmissionTest, WhenFullAnotherTakesThePlaceOfTheLongestSilentOfThatAddress) {
  for (const char* newcomer : {"10.0.0.2", "10.0.0.3"}) {
    const Admission admission = admission_of(address(newcomer), present(), 3);
    EXPECT_TRUE(admission.admitted);
    EXPECT_EQ(admission.displaced, 2U) << newcomer;
  }
}

TEST(AdmissionTest, WhenAllHoldTheSameTheLongestSilentGivesWayToAStranger) {
  const std::vector<Present> pair{{address("10.0.0.1"), time_from_ns(5)}, {address("10.0.0.2"), time_from_ns(1)}};
  EXPECT_EQ(admission_of(address("10.0.0.3"), pair, 2).displaced, 1U);
  EXPECT_FALSE(admission_of(address("10.0.0.2"), pair, 2).admitted);
}

TEST(AdmissionTest, OneThatNeverAskedGivesWayBeforeAnyThatDid) {
  const std::vector<Present> pair{{address("10.0.0.1"), time_from_ns(1), true}, {address("10.0.0.2"), time_from_ns(5)}};
  EXPECT_EQ(admission_of(address("10.0.0.3"), pair, 2).displaced, 1U);
}

TEST(AdmissionTest, NoRoomAtAllAdmitsNobody) { EXPECT_FALSE(admission_of(address("10.0.0.1"), {}, 0).admitted); }

}  // namespace
}  // namespace tripoint
