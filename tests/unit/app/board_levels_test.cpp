#include "app/board_levels.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "capture/image_file.h"
#include "places.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

/// A picture of 320x240 with a luma for each place: its parts are 16 px wide, 20 by 15 of them.
class Drawn {
 public:
  explicit Drawn(const std::function<int(int x, int y)>& luma) {
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) luma_.push_back(static_cast<std::uint8_t>(luma(x, y)));
    }
  }
  [[nodiscard]] BoardSight sight() const {
    return board_sight({.size = {320, 240}, .luma = {luma_.data(), 320, 1}, .u = {}, .v = {}});
  }

 private:
  std::vector<std::uint8_t> luma_;
};

/// Level 0.5 and 0.1 of 16 to 235.
constexpr double kWhiteLuma = 16.0 + 0.5 * 219.0;
constexpr double kBlackLuma = 16.0 + 0.1 * 219.0;

/// Squares of 12 px: a part of 16 px never lies within one.
int square(int x, int y, double white = kWhiteLuma, double black = kBlackLuma) {
  return static_cast<int>(std::lround((x / 12 + y / 12) % 2 == 0 ? black : white));
}

TEST(BoardLevelsTest, BothLevelsOfABoardAreRead) {
  const BoardSight sight = Drawn([](int x, int y) { return square(x, y); }).sight();
  ASSERT_TRUE(sight.levels);
  constexpr double kHalfCount = 0.5 / 219.0;
  EXPECT_NEAR(sight.levels->white, 0.5, kHalfCount);
  EXPECT_NEAR(sight.levels->black, 0.1, kHalfCount);
  EXPECT_NEAR(sight.levels->lightest, 0.5, kHalfCount);
  EXPECT_DOUBLE_EQ(sight.share, 18.0 * 13.0 / 300.0);  // on the picture's rim a part has five neighbours
}

/// 18 of 300 parts are 6 %. Of 8 x 5 parts 6 x 3 have eight neighbours, the others five at most.
TEST(BoardLevelsTest, ABoardMayBeSmallButNotSmaller) {
  const auto seen_with = [](int columns, int rows) {
    return Drawn([=](int x, int y) {
             const bool inside = x >= 64 && x < 64 + 16 * columns && y >= 32 && y < 32 + 16 * rows;
             return inside ? square(x, y) : 60;
           })
        .sight();
  };
  EXPECT_TRUE(seen_with(8, 5).levels);
  EXPECT_DOUBLE_EQ(seen_with(8, 5).share, 18.0 / 300.0);
  EXPECT_FALSE(seen_with(7, 5).levels);
  EXPECT_DOUBLE_EQ(seen_with(7, 5).share, 15.0 / 300.0);
}

TEST(BoardLevelsTest, AWindowBehindTheBoardDoesNotCount) {
  const BoardSight sight = Drawn([](int x, int y) { return x < 160 ? square(x, y) : 235; }).sight();
  ASSERT_TRUE(sight.levels);
  EXPECT_NEAR(sight.levels->white, 0.5, 0.01);
}

/// A tenth of the board clips: more than a twentieth.
TEST(BoardLevelsTest, GlareIsToldFromTheRest) {
  const BoardSight sight =
      Drawn([](int x, int y) { return y < 32 ? square(x, y, 235.0, 120.0) : square(x, y); }).sight();
  ASSERT_TRUE(sight.levels);
  EXPECT_NEAR(sight.levels->white, 0.5, 0.01);
  EXPECT_GE(sight.levels->lightest, kClippedWhite);
}

TEST(BoardLevelsTest, WhatHasNotTwoLevelsSideBySideIsNoBoard) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(100.0, 20.0);
  const std::vector<std::pair<std::string, std::function<int(int, int)>>> pictures{
      {"flat", [](int, int) { return 120; }},
      {"slope", [](int x, int) { return x * 200 / 320; }},
      {"noise", [&](int, int) { return static_cast<int>(noise(random)); }},
      {"one edge", [](int x, int) { return x < 168 ? 30 : 200; }},
      {"stripes far apart", [](int x, int) { return x / 40 % 2 == 0 ? 30 : 200; }},
      {"clipped", [](int x, int y) { return square(x, y, 235.0, 235.0); }},
      {"dark", [](int x, int y) { return square(x, y, 20.0, 16.0); }},
  };
  for (const auto& [name, luma] : pictures) EXPECT_FALSE(Drawn(luma).sight().levels) << name;
}

/// How many pictures of a folder show a board, and how many there are.
struct Seen {
  int boards = 0;
  int pictures = 0;
};

Seen seen_in(const std::string& folder) {
  Seen seen;
  for (const auto& entry : fs::recursive_directory_iterator(test::shared_folder() / "data" / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".jpg" && ending != ".png") continue;
    const Result<LoadedImage> image = LoadedImage::load(entry.path());
    EXPECT_TRUE(image) << image.error().message;
    if (!image) continue;
    ++seen.pictures;
    seen.boards += board_sight(image->picture()).levels ? 1 : 0;
  }
  return seen;
}

class RealBoardsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const fs::path folder = test::shared_folder() / "data";
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no such folder: " << folder << "; set TRIPOINT_SHARED";
  }
};

TEST_F(RealBoardsTest, EveryBoardIsSeen) {
  for (const auto& [folder, pictures] :
       {std::pair{"aprilgrid", 2}, {"charuco_mono_lifecam1280", 16}, {"stereo_opencv_chessboard", 26}}) {
    const Seen seen = seen_in(folder);
    EXPECT_EQ(seen.pictures, pictures) << folder;
    EXPECT_EQ(seen.boards, pictures) << folder;
  }
}

/// Two are: six large tags before the camera in test_image_multiple_07.png, and a wall with one and much print in
/// Loading_83in.jpg.
TEST_F(RealBoardsTest, RoomsWithTagsLampsAndTargetsAreNoBoards) {
  for (const auto& [folder, pictures, boards] : {std::tuple{"apriltag_duckietown", 10, 1},
                                                 {"apriltag_frc2024", 7, 1},
                                                 {"apriltag_swarmathon", 2, 0},
                                                 {"retroreflective_frc", 63, 0},
                                                 {"red_balls_davinci/RGB", 25, 0},
                                                 {"red_spot_scenes", 2, 0}}) {
    const Seen seen = seen_in(folder);
    EXPECT_EQ(seen.pictures, pictures) << folder;
    EXPECT_EQ(seen.boards, boards) << folder;
  }
}

}  // namespace
}  // namespace tripoint
