#include "sim/tag_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace tripoint {
namespace {

constexpr double kPixelVariance_px2 = 1.0 / 12.0;
constexpr double kStepsPerSigma = 6.0;  // along the path of a blurred edge: its width is then true to 0.12 %
constexpr int kMostSteps = 64;          // a limit for absurd speeds
constexpr int kRowTimeSteps = 6;        // each shrinks the error by the share of a row moved in a row time
constexpr double kMargin_px = 8.0;      // more than blur reaches, and edges bend between the points of the rim
constexpr int kRimPoints = 16;          // of a print, four to each side

/// A place on a print in its own plane; 1 is half the size of the square with the four corners.
Vec3 in_tag_mm(const PrintedTag& tag, const Vec2& place) {
  return {0.5 * tag.size_mm * place.x(), 0.5 * tag.size_mm * place.y(), 0.0};
}

constexpr std::array<std::array<double, 2>, kTagCorners> kCorners{{{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}};

/// Around the paper.
Vec2 rim_place(const PrintedTag& tag, int point) {
  constexpr int kToSide = kRimPoints / 4;
  const double edge = static_cast<double>(tag.cells.total) / tag.cells.across;
  const double along = 2.0 * (point % kToSide) / kToSide - 1.0;
  const int side = point / kToSide;
  const Eigen::Rotation2Dd quarters(0.5 * std::numbers::pi * side);
  return edge * (quarters * Vec2(along, -1.0));
}

bool inside(const RawPixel& at, ImageSize size) {
  return at.u_px >= -0.5 && at.v_px >= -0.5 && at.u_px < size.width_px - 0.5 && at.v_px < size.height_px - 0.5;
}

}  // namespace

/// Pixels that a tag may cover.
struct TagPainter::Extent {
  int left;
  int top;
  int right;
  int bottom;
};

TagPainter::TagPainter(const SimulatedWorld& world, Side side)
    : world_(world),
      side_(side),
      camera_(world.rig().cameras[side]),
      blur_px_(std::sqrt(std::pow(world.settings().sensor.optical_sigma_px, 2) + kPixelVariance_px2)) {
  if (!world.settings().scene.tags.empty()) rays_.emplace(camera_);
}

Isometry3 TagPainter::camera_from_tag(const PrintedTag& tag, Duration since_1970) const {
  return world_.camera_from_reference(side_, since_1970) * target_pose_at(world_.settings().trajectory, since_1970) *
         tag.target_from_tag;
}

Duration TagPainter::row_time(double row) const {
  return duration_from_seconds(row * seconds(world_.settings().line_time));
}

TagTruth TagPainter::truth_of(const PrintedTag& tag, Duration exposed_since_1970) const {
  TagTruth truth{.id = tag.id, .corners_px = {}, .front = false, .visible = true};
  const std::optional<TagSight> sight = sight_of(tag, camera_from_tag(tag, exposed_since_1970));
  truth.front = sight && sight->front;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec3 corner_mm = in_tag_mm(tag, {kCorners[k][0], kCorners[k][1]});
    RawPixel at;
    for (int i = 0; i <= kRowTimeSteps; ++i) {
      const double row = std::clamp(at.v_px, 0.0, camera_.size.height_px - 1.0);
      const Duration exposed = i == 0 ? exposed_since_1970 : exposed_since_1970 + row_time(row);
      const Result<RawPixel> seen = projected(camera_, camera_from_tag(tag, exposed) * corner_mm);
      truth.visible = truth.visible && seen;
      if (seen) at = *seen;
    }
    truth.corners_px[k] = at;
    truth.visible = truth.visible && inside(at, camera_.size);
  }
  return truth;
}

/// The rim of the paper from the first to the last moment of the exposure; all of the picture when a part of it is not
/// before the camera.
TagPainter::Extent TagPainter::extent_of(const PrintedTag& tag, Duration exposed_since_1970) const {
  const ImageSize size = camera_.size;
  const Duration half = world_.settings().exposure / 2;
  const Duration last_row = row_time(size.height_px - 1.0);
  Vec2 low(size.width_px, size.height_px);
  Vec2 high(-1.0, -1.0);
  for (const Duration moment : {-half, last_row / 2, last_row + half}) {
    const Isometry3 placed = camera_from_tag(tag, exposed_since_1970 + moment);
    for (int point = 0; point < kRimPoints; ++point) {
      const Result<RawPixel> at = projected(camera_, placed * in_tag_mm(tag, rim_place(tag, point)));
      if (!at) return {.left = 0, .top = 0, .right = size.width_px - 1, .bottom = size.height_px - 1};
      low = low.cwiseMin(Vec2(at->u_px, at->v_px));
      high = high.cwiseMax(Vec2(at->u_px, at->v_px));
    }
  }
  const auto limited = [](double px, int size_px) { return static_cast<int>(std::clamp(px, -1.0, size_px * 1.0)); };
  return {.left = std::max(limited(low.x() - kMargin_px, size.width_px), 0),
          .top = std::max(limited(low.y() - kMargin_px, size.height_px), 0),
          .right = std::min(limited(high.x() + kMargin_px, size.width_px), size.width_px - 1),
          .bottom = std::min(limited(high.y() + kMargin_px, size.height_px), size.height_px - 1)};
}

/// Instants into which the exposure of a row is cut.
int TagPainter::steps_of(const PrintedTag& tag, Duration exposed_since_1970) const {
  const Duration half = world_.settings().exposure / 2;
  const Isometry3 before = camera_from_tag(tag, exposed_since_1970 - half);
  const Isometry3 after = camera_from_tag(tag, exposed_since_1970 + half);
  double path_px = 0.0;
  for (int point = 0; point < kRimPoints; ++point) {
    const Vec3 place_mm = in_tag_mm(tag, rim_place(tag, point));
    const Result<RawPixel> from = projected(camera_, before * place_mm);
    const Result<RawPixel> to = projected(camera_, after * place_mm);
    if (from && to) path_px = std::max(path_px, std::hypot(to->u_px - from->u_px, to->v_px - from->v_px));
  }
  return static_cast<int>(std::clamp(std::ceil(kStepsPerSigma * path_px / blur_px_), 1.0, kMostSteps * 1.0));
}

/// How the tag stood at evenly spaced instants of a row's exposure.
std::vector<TagSight> TagPainter::sights_of_row(const PrintedTag& tag, Duration exposed_since_1970, int steps) const {
  std::vector<TagSight> sights;
  const double exposure_s = seconds(world_.settings().exposure);
  for (int i = 0; i < steps; ++i) {
    const Duration since_middle = duration_from_seconds(exposure_s * ((i + 0.5) / steps - 0.5));
    if (const auto sight = sight_of(tag, camera_from_tag(tag, exposed_since_1970 + since_middle))) {
      sights.push_back(*sight);
    }
  }
  return sights;
}

void TagPainter::paint(LightPlane& plane, const PrintedTag& tag, Duration exposed_since_1970) const {
  const Extent extent = extent_of(tag, exposed_since_1970);
  if (extent.left > extent.right) return;
  const int steps = steps_of(tag, exposed_since_1970);
  const double white_level = world_.settings().scene.white_level;
  for (int y = extent.top; y <= extent.bottom; ++y) {
    const std::vector<TagSight> sights = sights_of_row(tag, exposed_since_1970 + row_time(y), steps);
    const std::span<float> levels = plane.painted_row(y);
    for (int x = extent.left; x <= extent.right; ++x) {
      const std::optional<PixelRay>& ray = rays_->at(x, y);
      if (!ray) continue;
      TagCover sum;
      for (const TagSight& sight : sights) {
        const TagCover cover = cover_at(*ray, tag, sight, blur_px_, world_.normal());
        sum.share += cover.share;
        sum.light += cover.light;
      }
      float& here = levels[static_cast<std::size_t>(x)];
      here =
          static_cast<float>((1.0 - sum.share / steps) * static_cast<double>(here) + white_level * sum.light / steps);
    }
  }
}

std::vector<TagTruth> TagPainter::paint(LightPlane& plane, Duration exposed_since_1970) const {
  const std::vector<PrintedTag>& tags = world_.settings().scene.tags;
  std::vector<TagTruth> truths;
  std::vector<std::pair<double, const PrintedTag*>> by_depth;
  for (const PrintedTag& tag : tags) {
    truths.push_back(truth_of(tag, exposed_since_1970));
    by_depth.emplace_back(camera_from_tag(tag, exposed_since_1970).translation().norm(), &tag);
  }
  std::ranges::stable_sort(by_depth, std::ranges::greater{}, [](const auto& tag) { return tag.first; });
  for (const auto& [depth_mm, tag] : by_depth) paint(plane, *tag, exposed_since_1970);
  return truths;
}

}  // namespace tripoint
