#include "line/monitor/view_noise.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kAlike = 2.0;          // moving views of which the noise is taken for that of one
constexpr double kSamePixels_px = 1.0;  // a spot that moved by less errs as it did

double moved_px(const RawPixel& from, const RawPixel& to) {
  return std::hypot(to.u_px - from.u_px, to.v_px - from.v_px);
}

}  // namespace

void ViewNoise::add(double kept, const Matrix3& information, std::span<const LocatedPoint> points) {
  before_ *= kept;
  views_ *= kept;
  information_ *= kept;
  if (!rests(points)) {
    before_ += of_rest();
    at_.clear();
    for (const LocatedPoint& point : points) at_.push_back({point.pixels.left.at, point.pixels.right.at});
    views_ = 0.0;
    averaging_ = 1.0;
    information_.setZero();
  }
  views_ += 1.0;
  information_ += information;
  for (const LocatedPoint& point : points) averaging_ = std::min(averaging_, point.averaging);
}

/// At rest, a point that lies between two pictures is known no better than from one.
Matrix3 ViewNoise::of_rest() const { return std::max(kAlike, views_ > 1.0 ? views_ / averaging_ : 1.0) * information_; }

/// Whether any of the LEDs is where it was.
bool ViewNoise::rests(std::span<const LocatedPoint> points) const {
  const bool tags = points.front().next.has_value();
  if (tags) return true;
  if (points.size() != at_.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Side side : kBothSides) {
      if (moved_px(at_[i][side], points[i].pixels[side].at) < kSamePixels_px) return true;
    }
  }
  return false;
}

}  // namespace tripoint
