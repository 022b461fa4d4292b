#include "serve/responder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;
using testing::ElementsAre;

using Bytes = std::vector<std::uint8_t>;

class ResponderTest : public testing::Test {
 protected:
  Bytes ask(const Bytes& request, bool may_command = true) {
    const Pdu answer = responder_.answer(request, Asker{now_, may_command, 3, {}});
    return Bytes(answer.begin(), answer.end());
  }
  Bytes read(std::uint8_t function, unsigned address, unsigned count) {
    return ask({function, high(address), low(address), high(count), low(count)});
  }
  /// x, y and z as 0x80000000 each, in the order of words of the image or of the mirror.
  static Bytes unknown_position(unsigned order) {
    if (order == 0) return {3, 12, 0x80, 0, 0, 0, 0x80, 0, 0, 0, 0x80, 0, 0, 0};
    return {3, 12, 0, 0, 0x80, 0, 0, 0, 0x80, 0, 0, 0, 0x80, 0};
  }
  static std::uint8_t high(unsigned word) { return static_cast<std::uint8_t>(word >> 8U); }
  static std::uint8_t low(unsigned word) { return static_cast<std::uint8_t>(word & 0xFFU); }

  TimePoint now_ = kExposed + milliseconds(12);
  Publication publication_{unit_state()};
  Responder responder_{publication_, DeviceIdentification{}};
};

TEST_F(ResponderTest, BothTablesReadTheSameImage) {
  EXPECT_THAT(read(3, 0, 2), ElementsAre(3, 4, 0x54, 0x50, 0, 1));
  EXPECT_THAT(read(4, 0, 2), ElementsAre(4, 4, 0x54, 0x50, 0, 1));
}

TEST_F(ResponderTest, StateAndPoseComeInOneAnswer) {
  const Bytes answer = read(3, 32, 116);
  ASSERT_EQ(answer.size(), 2U + 232U);
  EXPECT_EQ(answer[2 + 2 * 5 + 1], 3);                                // register 37: clients
  EXPECT_EQ(answer[2 + 2 * (100 - 32)], answer[2 + 2 * (147 - 32)]);  // sequence first and last
}

TEST_F(ResponderTest, TheMirrorHasTheLeastSignificantWordFirst) {
  EXPECT_THAT(read(3, 2004, 4), ElementsAre(3, 8, 3, 4, 1, 2, 0x20, 0x00, 0x47, 0xF1));  // 123456.0 = 0x47F12000
  // 1 700 000 005 000 000 000 = 0x1797 9CFF 602F F200
  EXPECT_THAT(read(3, 104, 4), ElementsAre(3, 8, 0x17, 0x97, 0x9C, 0xFF, 0x60, 0x2F, 0xF2, 0x00));
  EXPECT_THAT(read(4, 2104, 4), ElementsAre(4, 8, 0xF2, 0x00, 0x60, 0x2F, 0x9C, 0xFF, 0x17, 0x97));
  EXPECT_EQ(read(3, 2000, 1), read(3, 0, 1));
}

TEST_F(ResponderTest, OnePublicationIsValidUpToTheAgeLimitAndStaleOneNanosecondLater) {
  constexpr unsigned kValidAndStale = 0x0014;  // bits 2 and 4
  now_ = kExposed + OutputLimits{}.age_limit;
  for (const unsigned order : {0U, 2000U}) {  // the mirror as well
    const Bytes fresh = read(3, order + 101, 1);
    EXPECT_EQ(fresh[3] & kValidAndStale, 0x04U) << order;
    EXPECT_NE(read(3, order + 110, 6), unknown_position(order)) << order;
  }
  EXPECT_THAT(read(3, 110, 2), ElementsAre(3, 4, 0xFF, 0xFF, 0xB7, 0x12));  // -18 670 um

  now_ += Duration{1};
  for (const unsigned order : {0U, 2000U}) {
    const Bytes stale = read(3, order + 101, 1);
    EXPECT_EQ(stale[3] & kValidAndStale, 0x10U) << order;
    EXPECT_EQ(read(3, order + 110, 6), unknown_position(order)) << order;
  }
}

TEST_F(ResponderTest, OnlyWholeRangesAreReadable) {
  EXPECT_EQ(read(3, 875, 125).size(), 252U);
  EXPECT_EQ(read(3, 2875, 125).size(), 252U);
  EXPECT_THAT(read(3, 1000, 1), ElementsAre(3, 2, 0, 0));
  for (const auto& [address, count] : std::initializer_list<std::pair<unsigned, unsigned>>{
           {999, 2}, {1000, 2}, {1001, 1}, {1999, 1}, {1999, 2}, {2999, 2}, {3000, 1}, {65535, 1}, {65535, 125}}) {
    EXPECT_THAT(read(3, address, count), ElementsAre(0x83, 2)) << address;
    EXPECT_THAT(read(4, address, count), ElementsAre(0x84, 2)) << address;
  }
}

TEST_F(ResponderTest, ABadQuantityIsRefusedBeforeTheAddressIsLookedAt) {
  EXPECT_THAT(read(3, 0, 0), ElementsAre(0x83, 3));
  EXPECT_THAT(read(3, 0, 126), ElementsAre(0x83, 3));
  EXPECT_THAT(read(4, 60000, 65535), ElementsAre(0x84, 3));
}

TEST_F(ResponderTest, APduThatDoesNotFillItsLengthIsRefusedAndChangesNothing) {
  EXPECT_THAT(ask({3}), ElementsAre(0x83, 3));
  EXPECT_THAT(ask({3, 0, 0, 0}), ElementsAre(0x83, 3));
  EXPECT_THAT(ask({3, 0, 0, 0, 1, 6, 3, 0xE8, 1, 1}), ElementsAre(0x83, 3));  // a write hidden behind a read
  EXPECT_THAT(ask({6, 3, 0xE8, 1}), ElementsAre(0x86, 3));
  EXPECT_THAT(ask({6, 3, 0xE8, 1, 1, 0}), ElementsAre(0x86, 3));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 1, 2, 1}), ElementsAre(0x90, 3));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 1, 4, 1, 1}), ElementsAre(0x90, 3));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 0, 0}), ElementsAre(0x90, 3));
  EXPECT_THAT(ask({23, 0, 0, 0, 1, 3, 0xE8, 0, 1, 2, 1}), ElementsAre(0x97, 3));
  EXPECT_THAT(ask({23, 0, 0, 0, 126, 3, 0xE8, 0, 1, 2, 1, 1}), ElementsAre(0x97, 3));
  EXPECT_THAT(read(3, 1000, 1), ElementsAre(3, 2, 0, 0));
}

TEST_F(ResponderTest, TheCommandWordIsWrittenByEachOfThreeFunctions) {
  EXPECT_THAT(ask({6, 3, 0xE8, 1, 1}), ElementsAre(6, 3, 0xE8, 1, 1));
  EXPECT_THAT(read(4, 1000, 1), ElementsAre(4, 2, 1, 1));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 1, 2, 1, 2}), ElementsAre(16, 3, 0xE8, 0, 1));
  EXPECT_THAT(read(3, 1000, 1), ElementsAre(3, 2, 1, 2));
  EXPECT_THAT(ask({23, 3, 0xE8, 0, 1, 3, 0xE8, 0, 1, 2, 1, 3}), ElementsAre(23, 2, 1, 3));  // written, then read
}

TEST_F(ResponderTest, NothingElseCanBeWritten) {
  EXPECT_THAT(ask({6, 0, 0, 1, 1}), ElementsAre(0x86, 2));
  EXPECT_THAT(ask({6, 3, 0xE9, 1, 1}), ElementsAre(0x86, 2));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 2, 4, 1, 1, 2, 2}), ElementsAre(0x90, 2));
  EXPECT_THAT(ask({16, 3, 0xE7, 0, 2, 4, 1, 1, 2, 2}), ElementsAre(0x90, 2));
  EXPECT_THAT(ask({23, 0xF0, 0, 0, 1, 3, 0xE8, 0, 1, 2, 1, 3}), ElementsAre(0x97, 2));
  EXPECT_THAT(read(3, 1000, 1), ElementsAre(3, 2, 0, 0));
}

TEST_F(ResponderTest, AClientThatIsNotNamedWritesNothing) {
  EXPECT_THAT(ask({6, 3, 0xE8, 1, 1}, false), ElementsAre(0x86, 2));
  EXPECT_THAT(ask({16, 3, 0xE8, 0, 1, 2, 1, 2}, false), ElementsAre(0x90, 2));
  EXPECT_THAT(ask({23, 3, 0xE8, 0, 1, 3, 0xE8, 0, 1, 2, 1, 3}, false), ElementsAre(0x97, 2));
  EXPECT_THAT(read(3, 1000, 1), ElementsAre(3, 2, 0, 0));
}

TEST_F(ResponderTest, EveryOtherFunctionIsIllegal) {
  for (unsigned function = 0; function < 256; ++function) {
    if (function == 3 || function == 4 || function == 6 || function == 16 || function == 23 || function == 43) continue;
    EXPECT_THAT(ask({static_cast<std::uint8_t>(function), 0, 0, 0, 1}), ElementsAre(function | 0x80U, 1)) << function;
  }
}

TEST_F(ResponderTest, ALatchCommandGoesThroughTheRegisters) {
  ask({6, 3, 0xE8, 0, 0});
  ask({6, 3, 0xE8, 1, 9});
  EXPECT_THAT(read(3, 40, 2), ElementsAre(3, 4, 1, 9, 0, 1));
  UnitState after = unit_state();
  after.newest->measurement.exposure_began = kExposed + milliseconds(13);
  publication_.publish(after, kExposed + milliseconds(12));
  EXPECT_THAT(read(3, 40, 3), ElementsAre(3, 6, 1, 9, 0, 2, 0, 0));
}

TEST_F(ResponderTest, BasicIdentificationHasThreeObjects) {
  const Bytes answer = ask({43, 14, 1, 0});
  ASSERT_GE(answer.size(), 7U);
  EXPECT_THAT(Bytes(answer.begin(), answer.begin() + 7), ElementsAre(43, 14, 1, 0x83, 0, 0, 3));
  EXPECT_EQ(std::string(answer.begin() + 9, answer.begin() + 17), "Tripoint");
}

TEST_F(ResponderTest, RegularAndExtendedIdentificationFitIntoOneAnswer) {
  EXPECT_EQ(ask({43, 14, 2, 0})[6], 7);
  EXPECT_EQ(ask({43, 14, 3, 0})[6], 9);
  EXPECT_EQ(ask({43, 14, 3, 0x80})[6], 2);
  EXPECT_EQ(ask({43, 14, 1, 77})[6], 3);  // an object that does not exist: from the first one
}

TEST_F(ResponderTest, OneObjectCanBeAskedFor) {
  const Bytes answer = ask({43, 14, 4, 0x81});
  EXPECT_EQ(std::string(answer.begin() + 9, answer.end()), "89abcdef");
  EXPECT_THAT(ask({43, 14, 4, 7}), ElementsAre(0xAB, 2));
}

TEST_F(ResponderTest, AMalformedIdentificationRequestIsRefused) {
  EXPECT_THAT(ask({43}), ElementsAre(0xAB, 3));
  EXPECT_THAT(ask({43, 13, 1, 0}), ElementsAre(0xAB, 1));
  EXPECT_THAT(ask({43, 14, 1}), ElementsAre(0xAB, 3));
  EXPECT_THAT(ask({43, 14, 0, 0}), ElementsAre(0xAB, 3));
  EXPECT_THAT(ask({43, 14, 5, 0}), ElementsAre(0xAB, 3));
}

}  // namespace
}  // namespace tripoint
