// A calibration board before the cameras: chessboard squares on white paper, drawn with the lens's distortion.
#pragma once

#include <span>

#include "geometry/camera_model.h"
#include "sim/normal_integral.h"
#include "values/linear.h"

namespace tripoint {

/// Flat, thin and evenly lit; its middle is the origin of its frame, its plane is z = 0, x runs along the rows. The
/// square in the corner of the smallest x and y is black. Edges are steps seen through the lens's blur, which must be
/// much smaller than a square.
struct Chessboard {
  Isometry3 reference_from_board = Isometry3::Identity();
  int columns = 10;  ///< squares; inner corners are one less
  int rows = 7;
  double square_mm = 24.0;
  double margin_mm = 12.0;          ///< white paper around the squares
  double white_reflectance = 0.8;   ///< of white paper
  double black_reflectance = 0.04;  ///< of printed black
};

/// How one camera sees the board.
struct BoardView {
  CameraModel camera;
  Isometry3 camera_from_reference = Isometry3::Identity();
  double blur_px = 0.8;  ///< standard deviation of the lens's blur; the pixel's own width is added
};

/// Draws the board over what a camera sees; it is nearer than anything else.
///
/// @param levels       mean level of each pixel, row by row, in units of clip
/// @param white_level  of a white surface
void paint_chessboard(std::span<float> levels, const Chessboard& board, const BoardView& view, double white_level,
                      const NormalIntegral& normal);

}  // namespace tripoint
