// Red spheres that only reflect: connected red areas whose outline is a circle.
#pragma once

#include <optional>
#include <vector>

#include "line/detect/candidate.h"
#include "line/detect/circle_fit.h"
#include "line/detect/led_detector.h"
#include "line/detect/red_patches.h"
#include "line/detect/sphere_settings.h"
#include "ports/frame.h"

namespace tripoint {

/// How many red areas are looked at in one picture, the largest first; more are cut and reported.
inline constexpr std::size_t kMaxSphereCandidates = 64;

/// A point is the centre of the outline. A sphere beside the optical axis appears as an ellipse whose centre lies
/// farther out than the picture of the sphere's centre. With the angular radius s (sin s = R/D) and the angle t from
/// the axis, the long axis ends at f tan(t - s) and f tan(t + s), so that its middle is f tan t / (1 - sin^2 s / cos^2
/// t); the short half axis is b = f sin s / sqrt(cos^2 t - sin^2 s). Together: centre of the ellipse = (1 + b^2/f^2)
/// times the picture of the centre. A single picture does not know f: the point is not moved, and the covariance states
/// the difference for the widest usual lens, f = 0.8 picture widths, in the direction from the middle of the picture.
///
/// A circle fits an ellipse that is seen all around in its centre, but a part of one elsewhere: the circle that touches
/// the end of the short axis b from within has the radius a^2/b, so that its centre lies a^2/b - b = b tan^2 t away.
/// The covariance states that times the share of the directions whose edge is not on the circle, in every direction.
class SphereDetector {
 public:
  explicit SphereDetector(const SphereSettings& settings) : settings_(settings) {}

  /// @param picture  whole and with chroma: a GREY picture is a bug of the caller
  Detection detect(const Picture& picture);

  /// Everything the last `detect` looked at, kept or dropped, with the cause.
  [[nodiscard]] const CandidateLog& candidates() const { return log_; }

 private:
  Candidate look(const Picture& picture, const RedPatch& patch);
  DropCause judge(const Picture& picture, const RedPatch& patch, Candidate& seen);
  void find_outline(const Picture& picture, const RedPatch& patch);
  [[nodiscard]] std::optional<Vec2> edge_along(const Picture& picture, const RedPatch& patch,
                                               const Vec2& direction) const;
  [[nodiscard]] double fill_of(const RedPatch& patch, const CircleFit& circle) const;
  DropCause keep(const Picture& picture, const CircleFit& circle, Candidate& seen);

  SphereSettings settings_;
  RedPatches patches_;
  FixedVector<Vec2, kOutlineDirections> outline_;
  CandidateLog log_;
  Detection detection_;
};

}  // namespace tripoint
