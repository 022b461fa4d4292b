// What a camera sees of the surfaces: a wall, and figures before it, the near ones over the far ones.
#pragma once

#include <vector>

#include "geometry/camera_model.h"
#include "sim/normal_integral.h"
#include "sim/scene.h"
#include "sim/silhouette.h"

namespace tripoint {

/// A surface with an outline, as one camera sees it.
struct Figure {
  Surface surface;
  Silhouette silhouette;
};

/// The figures in front of a camera, the farthest first.
std::vector<Figure> figures_of(const Scene& scene, const CameraModel& camera, const Isometry3& camera_from_reference,
                               double blur_px);

/// Mean level of each pixel under the mosaic, row by row, in units of clip: the surfaces without an outline in their
/// order, then the figures in theirs.
std::vector<float> painted(const Scene& scene, const std::vector<Figure>& figures, ImageSize size,
                           const NormalIntegral& normal);

}  // namespace tripoint
