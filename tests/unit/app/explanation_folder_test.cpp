#include "app/explanation_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "scratch_folder.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExplanationFolderTest : public testing::Test {
 protected:
  static void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  static std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  test::ScratchFolder top_;
};

TEST_F(ExplanationFolderTest, TheFolderIsMadeAndTheFileNamedAfterThePicture) {
  auto folder = ExplanationFolder::open(top_ / "new/why", {});
  ASSERT_TRUE(folder) << folder.error().message;
  const auto written = folder->write("elsewhere/left.1.jpg", "PNG");
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_EQ(*written, top_ / "new/why/left.1.explain.png");
  EXPECT_EQ(text_of(*written), "PNG");
}

TEST_F(ExplanationFolderTest, PicturesOfTheSameNameGetNumbers) {
  auto folder = ExplanationFolder::open(top_.path(), {});
  EXPECT_EQ(folder->write("a/x.png", "1"), top_ / "x.explain.png");
  EXPECT_EQ(folder->write("b/x.png", "2"), top_ / "x-2.explain.png");
  EXPECT_EQ(folder->write("x-2.jpg", "3"), top_ / "x-2-2.explain.png");
  EXPECT_EQ(folder->write("b/x.jpg", "4"), top_ / "x-3.explain.png");
  EXPECT_EQ(text_of(top_ / "x.explain.png"), "1");
}

TEST_F(ExplanationFolderTest, AnEarlierExplanationIsReplaced) {
  write(top_ / "x.explain.png", "of an earlier run");
  auto folder = ExplanationFolder::open(top_.path(), {});
  EXPECT_EQ(folder->write("x.png", "new"), top_ / "x.explain.png");
  EXPECT_EQ(text_of(top_ / "x.explain.png"), "new");
}

TEST_F(ExplanationFolderTest, AnInputIsNeverWrittenOverNotEvenByAnotherPath) {
  write(top_ / "x.explain.png", "a picture to look at");
  fs::create_directories(top_ / "other");
  const std::vector<fs::path> inputs{"x.png", top_ / "other/../x.explain.png"};
  auto folder = ExplanationFolder::open(top_.path(), inputs);
  EXPECT_EQ(folder->write("x.png", "new"), top_ / "x-2.explain.png");
  EXPECT_EQ(text_of(top_ / "x.explain.png"), "a picture to look at");
}

TEST_F(ExplanationFolderTest, AFileIsNoFolder) {
  write(top_ / "file", "");
  for (const fs::path& path : {top_ / "file", top_ / "file/below"}) {
    const auto folder = ExplanationFolder::open(path, {});
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error().code, ErrorCode::kCannotWrite);
    EXPECT_THAT(folder.error().message, HasSubstr(path.string()));
  }
}

TEST_F(ExplanationFolderTest, WhatCannotBeWrittenIsSaid) {
  fs::create_directories(top_ / "x.explain.png");
  auto folder = ExplanationFolder::open(top_.path(), {});
  const auto written = folder->write("x.png", "PNG");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
  EXPECT_THAT(written.error().message, HasSubstr("x.explain.png"));
}

}  // namespace
}  // namespace tripoint
