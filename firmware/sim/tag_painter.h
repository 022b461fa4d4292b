// Printed tags in the pictures of one camera: while they move, row by row, and where their corners truly are.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/pixel_rays.h"
#include "sim/spot.h"
#include "sim/tag_cover.h"
#include "sim/world.h"
#include "values/forecast.h"
#include "values/pixel.h"

namespace tripoint {

/// One tag in one picture.
struct TagTruth {
  int id = 0;
  /// Lower left, lower right, upper right, upper left of the upright print; each at the middle of the exposure of the
  /// very row in which it appears.
  std::array<RawPixel, kTagCorners> corners_px;
  bool front = false;    ///< the camera sees the printed side
  bool visible = false;  ///< all corners are in the picture; otherwise they may be anything
};

/// The world must outlive it.
class TagPainter {
 public:
  TagPainter(const SimulatedWorld& world, Side side);

  /// Draws the tags over what is there, the near ones over the far ones; each hides all that is behind it.
  ///
  /// @param exposed_since_1970  middle of the exposure of row 0
  /// @return in the scene's order
  std::vector<TagTruth> paint(LightPlane& plane, Duration exposed_since_1970) const;

 private:
  struct Extent;
  [[nodiscard]] Isometry3 camera_from_tag(const PrintedTag& tag, Duration since_1970) const;
  [[nodiscard]] Duration row_time(double row) const;
  [[nodiscard]] TagTruth truth_of(const PrintedTag& tag, Duration exposed_since_1970) const;
  [[nodiscard]] Extent extent_of(const PrintedTag& tag, Duration exposed_since_1970) const;
  [[nodiscard]] int steps_of(const PrintedTag& tag, Duration exposed_since_1970) const;
  void paint(LightPlane& plane, const PrintedTag& tag, Duration exposed_since_1970) const;
  [[nodiscard]] std::vector<TagSight> sights_of_row(const PrintedTag& tag, Duration exposed_since_1970,
                                                    int steps) const;

  const SimulatedWorld& world_;
  Side side_;
  CameraModel camera_;
  double blur_px_;
  std::optional<PixelRays> rays_;  ///< of a scene with tags
};

}  // namespace tripoint
