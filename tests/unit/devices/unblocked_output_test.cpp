#include "devices/unblocked_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

namespace tripoint {
namespace {

/// A pipe whose reading never waits.
std::array<int, 2> opened_pipe() {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return ends;
}

class UnblockedOutputTest : public ::testing::Test {
 protected:
  ~UnblockedOutputTest() override {
    close(ends_[0]);
    close(ends_[1]);
  }

  std::string read_all() {
    std::string all;
    std::array<char, 4096> some{};
    for (ssize_t got = 0; (got = read(ends_[0], some.data(), some.size())) > 0;) {
      all.append(some.data(), static_cast<std::size_t>(got));
    }
    return all;
  }

  std::array<int, 2> ends_ = opened_pipe();
  UnblockedOutput output_{ends_[1]};
};

TEST_F(UnblockedOutputTest, LinesGoThroughAsTheyAre) {
  output_.write("one\n");
  output_.write("two\n");
  EXPECT_EQ(read_all(), "one\ntwo\n");
}

// Where it waited, this test would not end.
TEST_F(UnblockedOutputTest, WhatAFullPipeDoesNotTakeIsDroppedAndCounted) {
  constexpr int kLines = 2000;
  const std::string line(99, 'x');
  for (int i = 0; i < kLines; ++i) output_.write(line + "\n");
  const auto taken = static_cast<int>(read_all().size() / 100);
  EXPECT_GT(taken, 100);
  EXPECT_LT(taken, kLines);
  output_.write("again\n");
  EXPECT_EQ(read_all(), "(" + std::to_string(kLines - taken) + " lines were dropped: nobody read them)\nagain\n");
  output_.write("and again\n");
  EXPECT_EQ(read_all(), "and again\n");
}

TEST_F(UnblockedOutputTest, ALineThatIsTooLongIsCut) {
  output_.write(std::string(10'000, 'x') + "\n");
  const std::string written = read_all();
  EXPECT_EQ(written.size(), UnblockedOutput::kLongest);
  EXPECT_EQ(written.back(), '\n');
}

TEST_F(UnblockedOutputTest, AReaderThatIsGoneEndsNothing) {
  close(ends_[0]);
  output_.write("to nobody\n");
  ends_[0] = dup(ends_[1]);  // to be closed
}

}  // namespace
}  // namespace tripoint
