#include "serve/command.h"

#include <gtest/gtest.h>

#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;
using registers::CommandResult;
using registers::CommandState;

constexpr TimePoint kBefore = kExposed - milliseconds(100);

class CommandTest : public testing::Test {
 protected:
  CommandStatus status(TimePoint now = kExposed) { return desk_.status(publication_.newest(now).latch); }

  Publication publication_{unit_state()};
  CommandDesk desk_{publication_};
};

TEST_F(CommandTest, AfterStartAWordDoesNothingUntilAZeroWasWritten) {
  desk_.write(0x0101, kBefore);
  EXPECT_EQ(desk_.word(), 0x0101);
  EXPECT_EQ(status().echo, 0);
  EXPECT_EQ(publication_.newest(kBefore).latch.outcome, LatchOutcome::kNone);
}

TEST_F(CommandTest, AWordAfterAZeroStartsALatchOnce) {
  desk_.write(0, kBefore);
  desk_.write(0x0101, kBefore);
  EXPECT_EQ(status(kBefore).state, CommandState::kBusy);
  EXPECT_EQ(status(kBefore).echo, 0x0101);
  desk_.write(0x0101, kBefore);
  EXPECT_EQ(publication_.newest(kBefore).latch.number, 1U);
}

TEST_F(CommandTest, ALatchIsDoneWhenThePoseIsThere) {
  desk_.write(0, kBefore);
  desk_.write(0x0101, kBefore);
  publication_.publish(unit_state(), kExposed);
  EXPECT_EQ(status().state, CommandState::kDone);
  EXPECT_EQ(status().result, CommandResult::kDone);
  EXPECT_EQ(status().detail, 70000 - 65536);
  desk_.write(0, kExposed);
  EXPECT_EQ(status().echo, 0);
  EXPECT_EQ(status().state, CommandState::kIdle);
  EXPECT_EQ(publication_.newest(kExposed).latch.outcome, LatchOutcome::kFilled);
}

TEST_F(CommandTest, ALatchWithoutAPoseInTimeHasFailedForGood) {
  desk_.write(0, kBefore);
  desk_.write(0x0101, kBefore);
  const TimePoint late = kBefore + kLatchWait + Duration{1};
  EXPECT_EQ(status(late).state, CommandState::kFailed);
  EXPECT_EQ(status(late).result, CommandResult::kNoPoseInTime);
  publication_.publish(unit_state(), late);
  EXPECT_EQ(status(late).state, CommandState::kFailed);
  EXPECT_EQ(publication_.newest(late).latch.copy, nullptr);
}

TEST_F(CommandTest, AnotherWordWithoutAZeroBetweenStartsNothing) {
  desk_.write(0, kBefore);
  desk_.write(0x0101, kBefore);
  desk_.write(0x0102, kBefore);
  EXPECT_EQ(status(kBefore).echo, 0x0101);
  EXPECT_EQ(publication_.newest(kBefore).latch.number, 1U);
}

TEST_F(CommandTest, ASecondLatchWhileOneRunsIsBusy) {
  desk_.write(0, kBefore);
  desk_.write(0x0101, kBefore);
  desk_.write(0, kBefore);
  desk_.write(0x0102, kBefore);
  EXPECT_EQ(status(kBefore).state, CommandState::kFailed);
  EXPECT_EQ(status(kBefore).result, CommandResult::kBusy);
  EXPECT_EQ(publication_.newest(kBefore).latch.number, 1U);
}

TEST_F(CommandTest, UnknownCodesAndTheTokenZeroAreRefused) {
  for (const std::uint16_t word : {std::uint16_t{0x0201}, std::uint16_t{0x0100}, std::uint16_t{0x0001}}) {
    desk_.write(0, kBefore);
    desk_.write(word, kBefore);
    EXPECT_EQ(status().echo, word);
    EXPECT_EQ(status().state, CommandState::kFailed) << word;
    EXPECT_EQ(status().result, CommandResult::kUnknownCode) << word;
  }
}

}  // namespace
}  // namespace tripoint
