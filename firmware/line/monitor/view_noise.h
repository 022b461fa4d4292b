// What the noise of image points leaves in a sum of views.
#pragma once

#include <span>

#include "line/pose/body_pose.h"
#include "values/fixed_vector.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/side.h"

namespace tripoint {

/// Covariance of a fading sum of normal equations' right sides. Noise is not new in every view: an LED on the same
/// pixels errs as it did, and a camera shifts the edges of tags alike wherever they are. So the sum of views at rest
/// spreads with their number, not with its root; and of a moving target two views count as one.
class ViewNoise {
 public:
  /// @param kept         weight that the views before keep
  /// @param information  of this view, from the covariance that its image points state
  /// @param points       by `located_target`
  void add(double kept, const Matrix3& information, std::span<const LocatedPoint> points);

  [[nodiscard]] Matrix3 covariance() const { return before_ + of_rest(); }

 private:
  [[nodiscard]] Matrix3 of_rest() const;
  [[nodiscard]] bool rests(std::span<const LocatedPoint> points) const;

  Matrix3 before_ = Matrix3::Zero();
  // Views that err alike, up to the newest:
  FixedVector<PerSide<RawPixel>, kMaxTargetPoints> at_;  // LEDs in the first of them
  double views_ = 0.0;                                   // with the weight that they have left
  double averaging_ = 1.0;                               // AlignedPoint's, the smallest
  Matrix3 information_ = Matrix3::Zero();
};

}  // namespace tripoint
