#include "line/measurement.h"

#include <set>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(BitSet16Test, KeepsEachMemberAtItsBitOfTheRegister) {
  // registers.md, register 34
  EXPECT_EQ(Faults{Fault::kNoCalibration}.bits(), 0x0001);
  EXPECT_EQ(Faults{Fault::kTimingBound}.bits(), 0x0200);
  EXPECT_EQ(Faults{Fault::kInternal}.bits(), 0x1000);
  EXPECT_EQ((Warnings{Warning::kSaturatedSpot, Warning::kFramesDropped}.bits()), 0x0021);
}

TEST(BitSet16Test, IsEmptyUntilSomethingIsInserted) {
  Faults faults;
  EXPECT_TRUE(faults.empty());
  faults.insert(Fault::kAmbiguous);
  EXPECT_FALSE(faults.empty());
  EXPECT_TRUE(faults.contains(Fault::kAmbiguous));
  EXPECT_FALSE(faults.contains(Fault::kEpipolarGate));
}

TEST(BitSet16Test, InsertingASetKeepsBoth) {
  Faults faults{Fault::kAmbiguous};
  faults.insert(Faults{Fault::kInternal});
  EXPECT_EQ(faults, (Faults{Fault::kInternal, Fault::kAmbiguous}));
}

TEST(FaultTest, EveryFaultHasAUniqueName) {
  const std::set<std::string_view> names(kFaultNames.begin(), kFaultNames.end());
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Fault::kInternal) + 1);
  EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace tripoint
