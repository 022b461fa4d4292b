#include "sim/chessboard.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tripoint {
namespace {

constexpr double kPixelVariance_px2 = 1.0 / 12.0;

/// Where a pixel looks at the board's plane, and how far the blur reaches there along both axes.
struct Spot {
  Vec2 place_mm;
  Vec2 sigma_mm;
};

/// One axis of the board at a place of it.
struct Axis {
  double paper_share;    ///< of the blurred pixel that lies on the paper
  double squares_share;  ///< on the squares
  double sign;           ///< between -1 and 1: on squares of odd or of even number
};

Axis axis_at(double place_mm, double sigma_mm, int squares, const Chessboard& board, const NormalIntegral& normal) {
  const auto share_up_to = [&](double edge_mm) {
    return static_cast<double>(normal(static_cast<float>((edge_mm - place_mm) / sigma_mm)));
  };
  const double half_mm = 0.5 * squares * board.square_mm;
  const double paper_mm = half_mm + board.margin_mm;
  const int nearest = std::clamp(static_cast<int>(std::lround((place_mm + half_mm) / board.square_mm)), 1, squares - 1);
  const double before_edge = share_up_to(nearest * board.square_mm - half_mm);
  const double step = nearest % 2 == 0 ? 1.0 : -1.0;  // squares of even number come after edges of even number
  return {.paper_share = share_up_to(paper_mm) - share_up_to(-paper_mm),
          .squares_share = share_up_to(half_mm) - share_up_to(-half_mm),
          .sign = step * (1.0 - 2.0 * before_edge)};
}

class Sight {
 public:
  Sight(const Chessboard& board, const BoardView& view)
      : camera_(view.camera),
        camera_from_board_(view.camera_from_reference * board.reference_from_board),
        edge_sigma_px_(std::sqrt(view.blur_px * view.blur_px + kPixelVariance_px2)) {}

  /// Nothing where the pixel does not look at the plane.
  [[nodiscard]] std::optional<Spot> at(const RawPixel& pixel) const {
    const Result<NormalizedPoint> direction = undistorted(camera_, pixel);
    if (!direction) return std::nullopt;
    const Vec3 normal = camera_from_board_.linear().col(2);
    const Vec3 along(direction->x, direction->y, 1.0);
    const double depth_mm = normal.dot(camera_from_board_.translation()) / normal.dot(along);
    if (!std::isfinite(depth_mm) || depth_mm <= 0.0) return std::nullopt;
    const Vec3 in_camera_mm = depth_mm * along;
    const Matrix2 px_per_mm =
        projection_jacobian_px_per_mm(camera_, in_camera_mm) * camera_from_board_.linear().leftCols<2>();
    const Matrix2 mm_per_px = px_per_mm.inverse();
    return Spot{.place_mm = (camera_from_board_.inverse() * in_camera_mm).head<2>(),
                .sigma_mm = edge_sigma_px_ * mm_per_px.rowwise().norm()};
  }

 private:
  CameraModel camera_;
  Isometry3 camera_from_board_;
  double edge_sigma_px_;
};

}  // namespace

void paint_chessboard(std::span<float> levels, const Chessboard& board, const BoardView& view, double white_level,
                      const NormalIntegral& normal) {
  const Sight sight(board, view);
  auto here = levels.begin();
  for (int y = 0; y < view.camera.size.height_px; ++y) {
    for (int x = 0; x < view.camera.size.width_px; ++x, ++here) {
      const std::optional<Spot> spot = sight.at({.u_px = static_cast<double>(x), .v_px = static_cast<double>(y)});
      if (!spot) continue;
      const Axis across = axis_at(spot->place_mm.x(), spot->sigma_mm.x(), board.columns, board, normal);
      const Axis down = axis_at(spot->place_mm.y(), spot->sigma_mm.y(), board.rows, board, normal);
      const double black_share = 0.5 * (1.0 + across.sign * down.sign) * across.squares_share * down.squares_share;
      const double level = white_level * std::lerp(board.white_reflectance, board.black_reflectance, black_share);
      *here = static_cast<float>(std::lerp(static_cast<double>(*here), level, across.paper_share * down.paper_share));
    }
  }
}

}  // namespace tripoint
