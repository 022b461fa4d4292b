#include "sim/renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tripoint {
namespace {

constexpr int kRowTimeSteps = 6;            // each shrinks the error by the share of a row moved in a row time
constexpr double kStepsPerSigma = 6.0;      // along the path of a blurred spot: its width is then true to 0.12 %
constexpr int kMaxBlurSteps = 400;          // a limit for absurd speeds
constexpr Duration kVelocityStep{250'000};  // for a difference quotient
constexpr double kTouching_mm = 1.0;        // a light this close before or behind a figure sits on it
constexpr double kMaskReachSigmas = 5.0;    // of the core, as far as it is drawn
constexpr double kMaskMargin_px = 64.0;     // no spot moves further while it is exposed

bool inside(const RawPixel& at, ImageSize size) {
  return at.u_px >= -0.5 && at.v_px >= -0.5 && at.u_px < size.width_px - 0.5 && at.v_px < size.height_px - 0.5;
}

YuvRange range_of(PixelFormat format) { return format == PixelFormat::kMjpeg ? YuvRange::kFull : YuvRange::kVideo; }

double sigma_px(const LightSource& light, double optical_sigma_px, double px_per_mm) {
  return std::hypot(optical_sigma_px, light.core_sigma_mm * px_per_mm);
}

/// Weighted by the core's light, at points half a standard deviation apart: a Gaussian is then summed to 1e-6.
double seen_share(const LightTruth& truth, double elongation, std::span<const Mask> masks,
                  const NormalIntegral& normal) {
  constexpr int kPoints = 8;
  const double step_px = 0.5 * truth.core_sigma_px * std::sqrt(elongation);
  double seen = 0.0;
  double all = 0.0;
  for (int i = -kPoints; i <= kPoints; ++i) {
    for (int j = -kPoints; j <= kPoints; ++j) {
      const double weight = std::exp(-(i * i + j * j) / 8.0);
      all += weight;
      seen += weight * passed_share(masks, truth.at.u_px + j * step_px, truth.at.v_px + i * step_px, normal);
    }
  }
  return seen / all;
}

/// How far a place lies before the plane of a figure.
double before_mm(const Outline& figure, const Vec3& place_mm) {
  return figure.facing.dot(place_mm - figure.center_in_reference_mm);
}

/// Whether the plane of a figure parts the camera from a place that does not sit on it.
bool is_between(const Outline& figure, const Vec3& camera_mm, const Vec3& place_mm) {
  const double place_before_mm = before_mm(figure, place_mm);
  return std::abs(place_before_mm) > kTouching_mm && place_before_mm * before_mm(figure, camera_mm) < 0.0;
}

/// Where the line from the camera to a place behind a figure's plane meets that plane.
Vec3 crossing_mm(const Outline& figure, const Vec3& camera_mm, const Vec3& place_mm) {
  const double camera_before_mm = before_mm(figure, camera_mm);
  return camera_mm + (place_mm - camera_mm) * camera_before_mm / (camera_before_mm - before_mm(figure, place_mm));
}

/// Where a light in a mirror seems to be; nothing when the mirror shows its back to the light or to the camera.
std::optional<Vec3> mirrored_mm(const Outline& mirror, const Vec3& place_mm, const Vec3& camera_mm) {
  const double light_before_mm = before_mm(mirror, place_mm);
  if (light_before_mm <= 0.0 || before_mm(mirror, camera_mm) <= 0.0) return std::nullopt;
  return place_mm - 2.0 * light_before_mm * mirror.facing;
}

}  // namespace

FrameRenderer::FrameRenderer(const SimulatedWorld& world, Side side)
    : world_(world),
      side_(side),
      tags_(world, side),
      light_(world.rig().cameras[side].size, world.background(side)),
      raw_(world.rig().cameras[side].size),
      developer_(raw_.size(), range_of(world.settings().format), world.settings().tone),
      packer_(raw_.size()) {
  const auto width = static_cast<std::size_t>(raw_.size().width_px);
  frame_.format = world.settings().format;
  frame_.size = raw_.size();
  frame_.line_time = world.settings().line_time;
  frame_.stride_bytes = frame_.format == PixelFormat::kYuyv ? 2 * width : width;
  if (frame_.format == PixelFormat::kMjpeg) frame_.stride_bytes = 0;
}

const RenderedFrame& FrameRenderer::render(Duration exposed_since_1970, std::uint64_t number) {
  light_.clear();
  frame_.truth = {.side = side_,
                  .exposed_since_1970 = exposed_since_1970,
                  .exposed = TimePoint{exposed_since_1970},
                  .stamp = TimePoint{exposed_since_1970},
                  .reference_from_target = target_pose_at(world_.settings().trajectory, exposed_since_1970),
                  .lights = {},
                  .tags = tags_.paint(light_, exposed_since_1970)};
  for (const LightSource& light : world_.settings().scene.lights) {
    frame_.truth.lights.push_back(add_light(light, exposed_since_1970));
  }
  expose(number);
  developer_.develop(raw_);
  encode();
  return frame_;
}

std::optional<FrameRenderer::Sight> FrameRenderer::sight_of(const LightSource& light, Duration since_1970) const {
  const Isometry3 camera_from_reference = world_.camera_from_reference(side_, since_1970);
  const Vec3 camera_mm = camera_from_reference.inverse().translation();
  Vec3 in_reference_mm = place_mm_at(light, since_1970);
  std::optional<Vec3> facing = light.facing;
  if (light.mount == Mount::kTarget) {
    const Isometry3 reference_from_target = target_pose_at(world_.settings().trajectory, since_1970);
    in_reference_mm = reference_from_target * in_reference_mm;
    if (facing) facing = reference_from_target.linear() * *facing;
  }
  if (light.mirror) {
    const std::optional<Vec3> image_mm = mirrored_mm(*light.mirror, in_reference_mm, camera_mm);
    if (!image_mm) return std::nullopt;
    in_reference_mm = *image_mm;
    if (facing) facing = *facing - 2.0 * facing->dot(light.mirror->facing) * light.mirror->facing;
  }
  if (facing && facing->dot(camera_mm - in_reference_mm) <= 0.0) return std::nullopt;
  const Vec3 in_camera_mm = camera_from_reference * in_reference_mm;
  const Result<RawPixel> at = projected(world_.rig().cameras[side_], in_camera_mm);
  if (!at) return std::nullopt;
  return Sight{.at = *at, .depth_mm = in_camera_mm.z(), .in_reference_mm = in_reference_mm};
}

double FrameRenderer::lit_share(const LightSource& light, Duration from_1970, Duration to_1970) const {
  const LitShare& share = world_.settings().lit_share;
  return share && light.switched_by ? share(*light.switched_by, from_1970, to_1970) : 1.0;
}

/// The row gives the time, the time gives the row.
std::optional<FrameRenderer::Sight> FrameRenderer::sight_by_row(const LightSource& light, LightTruth& truth) const {
  const Duration row_0 = truth.exposed_since_1970;
  std::optional<Sight> sight = sight_of(light, row_0);
  for (int i = 0; i < kRowTimeSteps && sight; ++i) {
    const double row = std::clamp(sight->at.v_px, 0.0, raw_.size().height_px - 1.0);
    truth.exposed_since_1970 = row_0 + duration_from_seconds(row * seconds(world_.settings().line_time));
    sight = sight_of(light, truth.exposed_since_1970);
  }
  return sight;
}

/// The figures between the camera and the light, or the mirror that shows it, and that mirror's edge.
std::vector<Mask> FrameRenderer::masks_before(const LightSource& light, const LightTruth& truth) const {
  const Isometry3& camera_from_reference = world_.rig().camera_from_rig[side_];
  const Vec3 camera_mm = camera_from_reference.inverse().translation();
  std::vector<Mask> masks;
  Vec3 shown_at_mm = truth.in_reference_mm;
  if (light.mirror) {
    const double blur_px = world_.settings().sensor.optical_sigma_px;
    const auto mirror = silhouette_of(*light.mirror, world_.rig().cameras[side_], camera_from_reference, blur_px);
    if (mirror) masks.push_back({.silhouette = *mirror, .shows_inside = true});
    shown_at_mm = crossing_mm(*light.mirror, camera_mm, truth.in_reference_mm);
  }
  const double reach_px = kMaskReachSigmas * truth.core_sigma_px * std::sqrt(light.elongation) + kMaskMargin_px;
  for (const Figure& figure : world_.figures(side_)) {
    const Silhouette& seen = figure.silhouette;
    if (!is_between(*figure.surface.outline, camera_mm, shown_at_mm)) continue;
    if (std::abs(seen.center.u_px - truth.at.u_px) > seen.reach_px.x() + reach_px) continue;
    if (std::abs(seen.center.v_px - truth.at.v_px) > seen.reach_px.y() + reach_px) continue;
    masks.push_back({.silhouette = seen});
  }
  return masks;
}

LightTruth FrameRenderer::add_light(const LightSource& light, Duration exposed_since_1970) {
  const SensorModel& sensor = world_.settings().sensor;
  LightTruth truth{.id = light.id, .at = {}, .exposed_since_1970 = exposed_since_1970};
  const std::optional<Sight> sight = sight_by_row(light, truth);
  if (!sight) return truth;
  const double px_per_mm = world_.rig().cameras[side_].focal_px.mean() / sight->depth_mm;
  const double px_per_mm_at_peak = px_per_mm * sight->depth_mm / kPeakDistance_mm;
  const double sigma_at_peak = sigma_px(light, sensor.optical_sigma_px, px_per_mm_at_peak);
  const double nearness = std::pow(kPeakDistance_mm / sight->depth_mm, 2);
  const double energy =
      2.0 * std::numbers::pi * sigma_at_peak * sigma_at_peak * light.peak * light.gain[side_] * nearness;
  truth.at = sight->at;
  truth.in_reference_mm = sight->in_reference_mm;
  truth.core_sigma_px = sigma_px(light, sensor.optical_sigma_px, px_per_mm);
  truth.peak = energy / (2.0 * std::numbers::pi * truth.core_sigma_px * truth.core_sigma_px);
  truth.visible = inside(sight->at, raw_.size());
  const Duration half = world_.settings().exposure / 2;
  truth.lit_share = lit_share(light, truth.exposed_since_1970 - half, truth.exposed_since_1970 + half);
  if (truth.lit_share <= 0.0) return truth;
  const std::vector<Mask> masks = masks_before(light, truth);
  if (!masks.empty()) truth.visible_share = seen_share(truth, light.elongation, masks, world_.normal());
  const double seen_energy = energy * truth.visible_share;
  add_gaussian(light, truth, {truth.core_sigma_px, light.elongation, energy, masks});
  add_gaussian(light, truth,
               {.sigma_px = light.halo_widening * truth.core_sigma_px,
                .elongation = light.elongation,
                .energy = seen_energy * light.halo_share * light.halo_widening * light.halo_widening});
  add_gaussian(light, truth,
               {.sigma_px = light.veil_of_width * raw_.size().width_px, .energy = seen_energy * light.veil_share});
  return truth;
}

/// Adds the spot at evenly spaced instants of the exposure.
void FrameRenderer::add_gaussian(const LightSource& light, const LightTruth& truth, const Gaussian& part) {
  if (part.energy <= 0.0) return;
  const SimulationSettings& settings = world_.settings();
  const Duration middle = truth.exposed_since_1970;
  const std::optional<Sight> before = sight_of(light, middle - kVelocityStep);
  const std::optional<Sight> after = sight_of(light, middle + kVelocityStep);
  if (!before || !after) return;
  const Vec2 velocity_px_per_s =
      Vec2(after->at.u_px - before->at.u_px, after->at.v_px - before->at.v_px) / seconds(2 * kVelocityStep);
  const double path_px = velocity_px_per_s.norm() * seconds(settings.exposure);
  const int steps = static_cast<int>(
      std::clamp(std::ceil(kStepsPerSigma * path_px / part.sigma_px), 1.0, static_cast<double>(kMaxBlurSteps)));
  const double exposure_s = seconds(settings.exposure);
  for (int i = 0; i < steps; ++i) {
    const auto since_middle = [&](double step) { return duration_from_seconds(exposure_s * (step / steps - 0.5)); };
    const std::optional<Sight> sight = sight_of(light, middle + since_middle(i + 0.5));
    const double lit = lit_share(light, middle + since_middle(i), middle + since_middle(i + 1.0));
    if (!sight || lit <= 0.0) continue;
    const double share = lit * part.energy / steps;
    light_.add({.at = sight->at,
                .sigma_px = part.sigma_px,
                .elongation = part.elongation,
                .elongation_angle_rad = light.elongation_angle_rad,
                .energy = {share * light.color[0], share * light.color[1], share * light.color[2]},
                .row_px = truth.at.v_px,
                .shift_px_per_row = velocity_px_per_s * seconds(settings.line_time)},
               world_.normal(), part.masks);
  }
}

void FrameRenderer::expose(std::uint64_t number) {
  const auto height = static_cast<std::uint64_t>(raw_.size().height_px);
  const std::uint64_t side = side_ == Side::kLeft ? 0 : 1;
  for (int y = 0; y < raw_.size().height_px; ++y) {
    const std::uint64_t key = (2 * number + side) * height + static_cast<std::uint64_t>(y);
    raw_.expose_row(y, light_.row(y), world_.noise().row(key), world_.settings().sensor);
  }
}

void FrameRenderer::encode() {
  const YuvPlanes& planes = developer_.planes();
  switch (frame_.format) {
    case PixelFormat::kYuyv:
      packer_.pack(planes);
      frame_.pixels = packer_.bytes();
      return;
    case PixelFormat::kGrey:
      frame_.pixels = planes.y;
      return;
    case PixelFormat::kMjpeg:
      frame_.pixels = jpeg_from(planes, world_.settings().mjpeg_sampling, world_.settings().mjpeg_quality);
      return;
  }
}

RenderedFrame render(const SimulatedWorld& world, Side side, Duration exposed_since_1970, std::uint64_t number) {
  return FrameRenderer(world, side).render(exposed_since_1970, number);
}

Frame frame_of(const RenderedFrame& rendered) {
  return {.side = rendered.truth.side,
          .format = rendered.format,
          .size = rendered.size,
          .stride_bytes = rendered.stride_bytes,
          .data = rendered.pixels,
          .sequence = 0,
          .exposed = rendered.truth.stamp,
          .arrived = rendered.truth.stamp,
          .line_time = rendered.line_time};
}

}  // namespace tripoint
