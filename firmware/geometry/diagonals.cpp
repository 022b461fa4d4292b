#include "geometry/diagonals.h"

#include <Eigen/LU>

namespace tripoint {

DiagonalCrossing diagonals_of(const std::array<Vec2, 4>& corners) {
  const std::array<Vec2, 2> ways{corners[2] - corners[0], corners[3] - corners[1]};
  Matrix2 normals;
  normals << -ways[0].y(), ways[0].x(), -ways[1].y(), ways[1].x();
  const Matrix2 place_by_across = normals.inverse();
  DiagonalCrossing crossing;
  crossing.at = place_by_across * Vec2(normals.row(0).dot(corners[0]), normals.row(1).dot(corners[1]));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t diagonal = k % 2;  // a corner moves its own diagonal alone, the more the nearer they meet to it
    const Vec2& way = ways[diagonal];
    const double share = (crossing.at - corners[diagonal]).dot(way) / way.squaredNorm();
    const double lever = k < 2 ? 1.0 - share : share;
    const auto row = static_cast<Eigen::Index>(diagonal);
    crossing.by_corners.middleCols<2>(static_cast<Eigen::Index>(2 * k)) =
        lever * place_by_across.col(row) * normals.row(row);
  }
  return crossing;
}

}  // namespace tripoint
