#include "line/match/straight_corners.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr int kPlaces = 16;               // along an edge; the bend of an edge is a parabola, which three would show
constexpr double kCornerMargin_px = 2.0;  // as the detector leaves out
constexpr double kMostMargin = 0.25;      // of the edge's length

using Places = std::array<Vec2, kTagCorners>;

struct Line {
  Vec2 on = Vec2::Zero();
  Vec2 along = Vec2::UnitX();
};

Vec2 place_of(const RawPixel& pixel) { return {pixel.u_px, pixel.v_px}; }

/// Least squares across the chord, along the part of the edge that the detector looks at.
Line line_along(const CameraModel& camera, const Vec2& from, const Vec2& to, double length_px) {
  const double margin = std::min(kMostMargin, kCornerMargin_px / length_px);
  std::array<Vec2, kPlaces> places;
  Vec2 middle = Vec2::Zero();
  for (int i = 0; i < kPlaces; ++i) {
    const double share = margin + (1.0 - 2.0 * margin) * i / (kPlaces - 1);
    const Vec2 straight = from + share * (to - from);
    places[static_cast<std::size_t>(i)] = place_of(distorted(camera, {straight.x(), straight.y()}));
    middle += places[static_cast<std::size_t>(i)] / kPlaces;
  }
  const Vec2 chord = (places.back() - places.front()).normalized();
  const Vec2 across(-chord.y(), chord.x());
  double mixed = 0.0;
  double spread = 0.0;
  for (const Vec2& place : places) {
    mixed += (place - middle).dot(chord) * (place - middle).dot(across);
    spread += std::pow((place - middle).dot(chord), 2);
  }
  return {middle, chord + mixed / spread * across};
}

Vec2 meeting(const Line& one, const Line& other) {
  Matrix2 ways;
  ways << one.along, -other.along;
  return one.on + (ways.inverse() * (other.on - one.on)).x() * one.along;
}

}  // namespace

Result<std::array<RawPixel, kTagCorners>> straight_corners(const CameraModel& camera,
                                                           const std::array<RawPixel, kTagCorners>& seen) {
  Places straight;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Result<NormalizedPoint> point = undistorted(camera, seen[k]);
    if (!point) return tl::make_unexpected(point.error());
    straight[k] = {point->x, point->y};
  }
  std::array<Line, kTagCorners> edges;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const std::size_t next = (k + 1) % kTagCorners;
    const double length_px = (place_of(seen[next]) - place_of(seen[k])).norm();
    edges[k] = line_along(camera, straight[k], straight[next], length_px);
  }
  std::array<RawPixel, kTagCorners> corners;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec2 moved_px = meeting(edges[(k + kTagCorners - 1) % kTagCorners], edges[k]) - place_of(seen[k]);
    corners[k] = {seen[k].u_px - moved_px.x(), seen[k].v_px - moved_px.y()};
  }
  return corners;
}

}  // namespace tripoint
