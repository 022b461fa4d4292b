#include "document/file.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scratch_folder.h"

namespace tripoint {
namespace {

class FileTest : public ::testing::Test {
 protected:
  [[nodiscard]] auto files_in_folder() const {
    return std::distance(std::filesystem::directory_iterator{folder_.path()}, std::filesystem::directory_iterator{});
  }

  test::ScratchFolder folder_;
};

TEST_F(FileTest, WhatWasWrittenIsRead) {
  const std::string bytes{"a\0b\n", 4};
  ASSERT_TRUE(write_file_whole(folder_ / "f", bytes).has_value());
  EXPECT_EQ(read_file(folder_ / "f", 4).value(), bytes);
}

TEST_F(FileTest, WritingReplacesAndLeavesNothingBeside) {
  ASSERT_TRUE(write_file_whole(folder_ / "f", std::string(100'000, 'x')).has_value());
  ASSERT_TRUE(write_file_whole(folder_ / "f", "new").has_value());
  EXPECT_EQ(read_file(folder_ / "f", 100).value(), "new");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(FileTest, AWriteThatFailsLeavesTheOldAndNothingBeside) {
  std::filesystem::create_directories(folder_ / "f" / "in the way");  // rename onto a folder with content fails
  const auto result = write_file_whole(folder_ / "f", "new");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::kCannotWrite);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "f" / "in the way"));
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(FileTest, WritingIntoAMissingFolderIsAnErrorWithThePath) {
  const auto result = write_file_whole(folder_ / "none" / "f", "x");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::kCannotWrite);
  EXPECT_THAT(result.error().message, ::testing::HasSubstr((folder_ / "none" / "f").string()));
}

TEST_F(FileTest, ReadingHasALimit) {
  ASSERT_TRUE(write_file_whole(folder_ / "f", std::string(20'000, 'x')).has_value());
  EXPECT_EQ(read_file(folder_ / "f", 20'000)->size(), 20'000U);
  EXPECT_EQ(read_file(folder_ / "f", 19'999).error().code, ErrorCode::kCannotRead);
}

TEST_F(FileTest, WhatIsNoFileCannotBeRead) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);  // opening it for reading must not wait for a writer
  EXPECT_EQ(read_file(folder_ / "pipe", 10).error().code, ErrorCode::kCannotRead);
  EXPECT_EQ(read_file(folder_.path(), 10).error().code, ErrorCode::kCannotRead);
  EXPECT_EQ(read_file(folder_ / "none", 10).error().code, ErrorCode::kCannotRead);
}

}  // namespace
}  // namespace tripoint
