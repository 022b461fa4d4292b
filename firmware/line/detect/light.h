// Whether a spot is red light at all: what colour its flank has, and what a mere red surface could show in this
// picture.
#pragma once

#include "line/detect/candidate.h"
#include "ports/frame.h"

namespace tripoint {

/// How a picture is lit, of a sparse sample of its luma.
struct SceneLight {
  double mean_luma = 0.0;
  int white_luma = 0;  ///< a twentieth of the picture is brighter: what a white surface may show
};

SceneLight scene_light_of(const Picture& picture);

/// S of a pure red surface that reflects as much red as a white one: no reflecting thing in that light is stronger. A
/// lamp that lights up less than a twentieth of the picture is another light.
///
/// Source: S = 3 Y + 4 V of red alone, ITU-R BT.601; the same for luma from 16 to 235 and from 0 to 255 within 2 %.
int strength_of_red_surface(const SceneLight& light);

/// -dU/dV over the flank of a spot (12 to 85 % of its contrast, red not clipped) against its surroundings.
///
/// Pure red has 0.34. A red LED behind mosaic and tone curve has 0 to 0.5, however bright it is: in the flank nothing
/// clips. Each tenth of green in the light adds about 0.2; orange has 0.7 and more.
///
/// @param candidate  its place, radius, peak, contrast and the V of its surroundings are known
/// @return 0 when nothing of the flank is redder than its surroundings
/// Source of the value for pure red: ITU-R BT.601, 0.169 / 0.5.
double hue_of_flank(const Picture& picture, const Candidate& candidate);

}  // namespace tripoint
