#include "line/detect/ground.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "line/detect/vectors.h"

namespace tripoint {
namespace {

constexpr double kRoughest = 3.0;  // steps: the unevenness that a slope of one step in 6 px makes in the ring
constexpr double kOfNoise = 4.0;
constexpr double kFewest = 32.0;  // pixels of a plane
constexpr int kStep_px = 2;       // every second pixel of every sixth row: noise averages out over the ring
constexpr int kRowStep = 3 * kStep_px;
constexpr int kVector_px = 4 * kStep_px;

/// A ring in the picture, and what of it belongs to the ground.
struct Ring {
  int column = 0;  ///< middle
  int row = 0;
  int inner_px2 = 0;  ///< squares of the radii
  int outer_px2 = 0;
  int first = 0;  ///< column; whole vectors from here
  int last = 0;   ///< up to here
  int luma = 0;
  int limit = 0;  ///< less than that above and below `luma`
};

int sum(Ints4 v) { return v[0] + v[1] + v[2] + v[3]; }

/// Every second of eight pixels.
Ints4 four_lumas(const Plane& luma, int u, int v) {
  const std::uint8_t* first =
      luma.data + static_cast<std::size_t>(v) * luma.stride_bytes + static_cast<std::size_t>(u) * luma.step_bytes;
  if (luma.step_bytes == 2) return reinterpret_cast<Ints4>(loaded<Words4>(first) & 0xFFU);
  const auto eight = loaded<Bytes8>(first);
  return __builtin_convertvector(__builtin_shufflevector(eight, eight, 0, 2, 4, 6), Ints4);
}

/// The neighbour of each but the last.
Ints4 next(Ints4 v) { return __builtin_shufflevector(v, v, 1, 2, 3, 3); }
constexpr Ints4 kNotLast{-1, -1, -1, 0};

/// The plane rise = a + b x + c y by least squares, x and y from the ring's middle.
class PlaneFit {
 public:
  /// @param beside  the row to compare with, of the same phase of the mosaic
  void add_row(const Plane& luma, const Ring& ring, int v, int beside) {
    const int y = v - ring.row;
    Ints4 x = Ints4{0, kStep_px, 2 * kStep_px, 3 * kStep_px} + (ring.first - ring.column);
    Ints4 n{}, sum_x{}, sum_rise{};
    for (int u = ring.first; u + kVector_px - 1 <= ring.last; u += kVector_px, x += kVector_px) {
      const Ints4 rise = four_lumas(luma, u, v) - ring.luma;
      const Ints4 rise_beside = four_lumas(luma, u, beside) - ring.luma;
      const Ints4 xx = x * x;
      const Ints4 distance_px2 = xx + y * y;
      const Ints4 kept = (distance_px2 > ring.inner_px2) & (distance_px2 < ring.outer_px2) & (rise < ring.limit) &
                         (rise > -ring.limit);
      const Ints4 both = kept & (rise_beside < ring.limit) & (rise_beside > -ring.limit);
      const Ints4 kept_rise = rise & kept;
      const Ints4 step = (rise - rise_beside) & both;
      const Ints4 along = kept & next(kept) & kNotLast;
      const Ints4 step_along = (next(rise) - rise) & along;
      n -= kept;
      sum_x += x & kept;
      sum_rise += kept_rise;
      xx_ += xx & kept;
      x_rise_ += x * kept_rise;
      steps_ -= both;
      step_step_ += step * step;
      steps_along_ -= along;
      step_step_along_ += step_along * step_along;
    }
    n_ += n, x_ += sum_x, rise_ += sum_rise;
    y_ += y * n, yy_ += y * y * n, xy_ += y * sum_x, y_rise_ += y * sum_rise;
  }

  /// @return b and c; zero when the pixels are too few or lie on a line
  [[nodiscard]] Vec2 slope() const {
    const double n = sum(n_);
    if (n < kFewest) return Vec2::Zero();
    const Vec2 mean = Vec2(sum(x_), sum(y_)) / n;
    Matrix2 squares;
    squares << sum(xx_), sum(xy_), sum(xy_), sum(yy_);
    const Matrix2 spread = squares - n * mean * mean.transpose();
    if (spread.determinant() < n) return Vec2::Zero();
    return spread.inverse() * (Vec2(sum(x_rise_), sum(y_rise_)) - sum(rise_) * mean);
  }

  /// Half of the mean square between two pixels is the variance of one; stripes show in one direction only.
  [[nodiscard]] double grain() const {
    const double down = 0.5 * sum(step_step_) / std::max(1, sum(steps_));
    const double along = 0.5 * sum(step_step_along_) / std::max(1, sum(steps_along_));
    return std::sqrt(std::min(down, along));
  }

 private:
  // Sums over the kept pixels of 1, x, y, their products and their products with the rise, in four lanes.
  Ints4 n_{}, x_{}, y_{}, xx_{}, xy_{}, yy_{}, rise_{}, x_rise_{}, y_rise_{};
  Ints4 steps_{}, step_step_{};              // from row to row
  Ints4 steps_along_{}, step_step_along_{};  // along the row
};

double outer_radius_px(double radius_px) { return 3.0 * radius_px + 12.0; }

int square_of(double radius_px) { return static_cast<int>(radius_px * radius_px); }

}  // namespace

GroundPlane ground_plane(const Picture& picture, const RawPixel& at, double radius_px, const Ground& ground) {
  const double inner_px = 1.6 * radius_px + 3.0;  // outside of what the fit sees
  const double outer_px = outer_radius_px(radius_px);
  const auto column = static_cast<int>(std::lround(at.u_px));
  const auto row = static_cast<int>(std::lround(at.v_px));
  const auto reach = static_cast<int>(outer_px);
  const ImageSize size = picture.size;
  if (size.height_px <= kStep_px) return {};
  const Ring ring{.column = column,
                  .row = row,
                  .inner_px2 = square_of(inner_px),
                  .outer_px2 = square_of(outer_px),
                  .first = std::max(0, column - reach),
                  .last = std::min(size.width_px - 1, column + reach + kVector_px - 1),
                  .luma = static_cast<int>(ground.luma),
                  .limit = static_cast<int>(2.0 + kOfNoise * ground.noise)};
  PlaneFit fit;
  for (int v = std::max(0, row - reach); v <= std::min(size.height_px - 1, row + reach); v += kRowStep) {
    const int beside = v + kStep_px < size.height_px ? v + kStep_px : v - kStep_px;
    fit.add_row(picture.luma, ring, v, beside);
  }
  return {.slope = fit.slope(), .rough = ground.noise > kRoughest, .grain = fit.grain()};
}

int ground_reach_px(double radius_px) { return static_cast<int>(outer_radius_px(radius_px)) + kStep_px; }

}  // namespace tripoint
