// Labelled corners of tags as two cameras see them, moved as errors of the tags' edges move them.
#pragma once

#include <array>
#include <random>

#include "geometry/camera_model.h"
#include "line/model.h"
#include "line/observation.h"
#include "values/linear.h"

namespace tripoint::bench {

/// A flat square tag in the target's x, y plane, its front towards -z.
void add_tag(Target& target, int id, double size_mm, const Vec3& centre_mm, double uncertainty_mm = 0.0);

using CornerPlaces = std::array<Vec2, kTagCorners>;
using CornerSpread = Eigen::Matrix<double, 2 * kTagCorners, 2 * kTagCorners>;

/// Where straight lines along the pictures of a tag's edges meet, which a lens bends.
CornerPlaces meetings_of_edges(const CameraModel& camera, const std::array<Vec3, kTagCorners>& corners_in_camera);

struct SeenCorners {
  CornerPlaces places;
  CornerSpread covariance;
};

/// Corners where the edges meet after each was moved and turned a little. Places along an edge err by a standard
/// deviation that leaves `sigma_px` at its middle: a straight line through them is then known by the root of 12 over
/// the length in its angle.
SeenCorners with_edge_errors(const CornerPlaces& corners, double sigma_px, std::mt19937_64& random);

/// Standard deviations of what tags are measured by.
struct TagErrors {
  double edge_px = 0.02;   ///< of the middle of each edge
  double corner_px = 0.0;  ///< of each corner beside that, as what a camera does to whole edges is taken
};

/// What one camera sees of the target's tags.
void add_tags(Observation& seen, const LineModel& model, const Isometry3& rig_from_target, const TagErrors& errors,
              std::mt19937_64& random);

}  // namespace tripoint::bench
