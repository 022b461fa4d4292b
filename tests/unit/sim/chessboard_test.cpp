#include "sim/chessboard.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

constexpr double kWhiteLevel = 0.9;

/// Turned about all three axes, so that perspective and distortion count.
Chessboard tilted_board() {
  Chessboard board;
  board.reference_from_board.translation() = Vec3(10.0, -5.0, 430.0);
  board.reference_from_board.linear() = Eigen::AngleAxisd(0.5, Vec3(0.3, 0.9, 0.2).normalized()).toRotationMatrix();
  return board;
}

SimulatedWorld world_with(const Chessboard& board) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights.clear();
  settings.scene.board = board;
  settings.scene.white_level = kWhiteLevel;
  return world_of(settings);
}

/// Between the four pixels around a place, linearly.
double level_at(const SimulatedWorld& world, Side side, const RawPixel& at) {
  const auto left = static_cast<std::size_t>(std::floor(at.u_px));
  const auto top = static_cast<std::size_t>(std::floor(at.v_px));
  const double right_share = at.u_px - static_cast<double>(left);
  const double lower_share = at.v_px - static_cast<double>(top);
  const auto level = [&](std::size_t x, std::size_t y) {
    return static_cast<double>(world.background(side)[y * 640 + x]);
  };
  return std::lerp(std::lerp(level(left, top), level(left + 1, top), right_share),
                   std::lerp(level(left, top + 1), level(left + 1, top + 1), right_share), lower_share);
}

class BoardInPictureTest : public ::testing::TestWithParam<Side> {
 protected:
  /// Of a place in squares from the middle of the board.
  [[nodiscard]] double level(double across, double down) const {
    const Vec3 in_board_mm(across * board_.square_mm, down * board_.square_mm, 0.0);
    const Vec3 in_camera_mm = world_.rig().camera_from_rig[GetParam()] * board_.reference_from_board * in_board_mm;
    return level_at(world_, GetParam(), projected(world_.rig().cameras[GetParam()], in_camera_mm).value());
  }

  Chessboard board_ = tilted_board();
  SimulatedWorld world_ = world_with(board_);
  double white_ = kWhiteLevel * board_.white_reflectance;
  double black_ = kWhiteLevel * board_.black_reflectance;
};

TEST_P(BoardInPictureTest, SquaresAreBlackAndWhiteInTurnFromABlackOneOn) {
  for (int row = 0; row < board_.rows; ++row) {
    for (int column = 0; column < board_.columns; ++column) {
      const double expected = (row + column) % 2 == 0 ? black_ : white_;
      EXPECT_NEAR(level(column + 0.5 - 5.0, row + 0.5 - 3.5), expected, 1e-6) << row << " " << column;
    }
  }
}

/// In the middle of an edge the level is that between both squares. Its slope there is (white - black) / (sigma
/// sqrt(2 pi)), about half of the contrast a pixel: a place wrong by 0.02 px would be seen.
TEST_P(BoardInPictureTest, EdgesLieWhereTheCameraProjectsThem) {
  const double middle = 0.5 * (white_ + black_);
  const double tolerance = 0.01 * (white_ - black_);
  for (int row = 0; row < board_.rows; ++row) {
    for (int edge = 1; edge < board_.columns; ++edge) {
      EXPECT_NEAR(level(edge - 5.0, row + 0.5 - 3.5), middle, tolerance) << row << " " << edge;
    }
  }
  for (int edge = 1; edge < board_.rows; ++edge) {
    for (int column = 0; column < board_.columns; ++column) {
      EXPECT_NEAR(level(column + 0.5 - 5.0, edge - 3.5), middle, tolerance) << edge << " " << column;
    }
  }
}

TEST_P(BoardInPictureTest, WhitePaperSurroundsTheSquaresAndHidesTheWall) {
  EXPECT_NEAR(level(-5.25, -2.0), white_, 1e-6);  // beside a black square
  EXPECT_NEAR(level(0.0, 3.75), white_, 1e-6);
  EXPECT_NEAR(level(-5.5, 0.0), 0.5 * white_, 0.01 * white_);  // the edge of the paper, before a black wall
  EXPECT_NEAR(level(-5.8, 0.0), 0.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(BothCameras, BoardInPictureTest, ::testing::Values(Side::kLeft, Side::kRight));

TEST(ChessboardTest, ABoardBehindTheCameraIsNotSeen) {
  Chessboard board;
  board.reference_from_board.translation() = Vec3(0.0, 0.0, -400.0);
  const SimulatedWorld world = world_with(board);
  for (const Side side : kBothSides) {
    for (const float level : world.background(side)) ASSERT_EQ(level, 0.0F);
  }
}

}  // namespace
}  // namespace tripoint
