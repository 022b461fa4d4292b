// The pixels of a target's points as rows of least squares: how far off a pose they are, and what they err by.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "line/model.h"
#include "line/pose/body_pose.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

inline constexpr int kPixels = 4;  ///< rows of a point: left u v, right u v
inline constexpr int kMostRows = kPixels * static_cast<int>(kTagCorners);

constexpr Eigen::Index first_row(Side side) { return side == Side::kLeft ? 0 : 2; }
constexpr Eigen::Index row_of(std::size_t point) { return static_cast<Eigen::Index>(kPixels * point); }

using PixelRows = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;
using PixelRowsByPose = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMostRows, 6>;
using PixelCovariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRows, kMostRows>;

/// From the point `first` on, those whose image points err together: the corners of one tag, or a point by itself.
std::span<const LocatedPoint> part_from(std::span<const LocatedPoint> points, std::size_t first);

/// Of the image points of one part, the edges that corners share included; without what time adds, which is one for all
/// points.
PixelCovariance spots_covariance_px2(std::span<const LocatedPoint> part);

/// d(left u v, right u v; px) / d(place in the rig, mm). The place lies in front of both cameras.
Eigen::Matrix<double, kPixels, 3> pixels_by_place(const Rig& rig, const Vec3& place_in_rig_mm);

/// Pixels seen less those of the target at a pose, and how the latter follow it (PoseParameters).
struct PixelOffset {
  PixelRows px;
  PixelRowsByPose by_pose;
};

/// @return nothing when a point lies behind a camera
std::optional<PixelOffset> pixel_offset(const Isometry3& rig_from_target, std::span<const LocatedPoint> part,
                                        const Rig& rig);

}  // namespace tripoint
