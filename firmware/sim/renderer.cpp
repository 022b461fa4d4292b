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

bool inside(const RawPixel& at, ImageSize size) {
  return at.u_px >= -0.5 && at.v_px >= -0.5 && at.u_px < size.width_px - 0.5 && at.v_px < size.height_px - 0.5;
}

YuvRange range_of(PixelFormat format) { return format == PixelFormat::kMjpeg ? YuvRange::kFull : YuvRange::kVideo; }

double sigma_px(const LightSource& light, double optical_sigma_px, double px_per_mm) {
  return std::hypot(optical_sigma_px, light.core_sigma_mm * px_per_mm);
}

LinearColor energy_of(const LightSource& light, double energy) {
  return {energy * light.color[0], energy * light.color[1], energy * light.color[2]};
}

}  // namespace

FrameRenderer::FrameRenderer(const SimulatedWorld& world, Side side)
    : world_(world),
      side_(side),
      light_(world.rig().cameras[side].size, world.background(side)),
      raw_(world.rig().cameras[side].size),
      developer_(raw_.size(), range_of(world.settings().format)),
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
                  .lights = {}};
  for (const LightSource& light : world_.settings().scene.lights) {
    frame_.truth.lights.push_back(add_light(light, exposed_since_1970));
  }
  expose(number);
  developer_.develop(raw_);
  encode();
  return frame_;
}

std::optional<FrameRenderer::Sight> FrameRenderer::sight_of(const LightSource& light, Duration since_1970) const {
  const Vec3 in_reference_mm = light.mount == Mount::kReference
                                   ? light.place_mm
                                   : target_pose_at(world_.settings().trajectory, since_1970) * light.place_mm;
  const Vec3 in_camera_mm = world_.rig().camera_from_rig[side_] * in_reference_mm;
  const Result<RawPixel> at = projected(world_.rig().cameras[side_], in_camera_mm);
  if (!at) return std::nullopt;
  return Sight{.at = *at, .depth_mm = in_camera_mm.z(), .in_reference_mm = in_reference_mm};
}

LightTruth FrameRenderer::add_light(const LightSource& light, Duration exposed_since_1970) {
  const SimulationSettings& settings = world_.settings();
  LightTruth truth{.id = light.id, .at = {}, .exposed_since_1970 = exposed_since_1970};
  std::optional<Sight> sight = sight_of(light, exposed_since_1970);
  for (int i = 0; i < kRowTimeSteps && sight; ++i) {  // the row gives the time, the time gives the row
    const double row = std::clamp(sight->at.v_px, 0.0, raw_.size().height_px - 1.0);
    truth.exposed_since_1970 = exposed_since_1970 + duration_from_seconds(row * seconds(settings.line_time));
    sight = sight_of(light, truth.exposed_since_1970);
  }
  if (!sight) return truth;
  const double px_per_mm = world_.rig().cameras[side_].focal_px.mean() / sight->depth_mm;
  const double px_per_mm_at_peak = px_per_mm * sight->depth_mm / kPeakDistance_mm;
  const double sigma_at_peak = sigma_px(light, settings.sensor.optical_sigma_px, px_per_mm_at_peak);
  const double nearness = std::pow(kPeakDistance_mm / sight->depth_mm, 2);
  const double energy = 2.0 * std::numbers::pi * sigma_at_peak * sigma_at_peak * light.peak * nearness;
  truth.at = sight->at;
  truth.in_reference_mm = sight->in_reference_mm;
  truth.core_sigma_px = sigma_px(light, settings.sensor.optical_sigma_px, px_per_mm);
  truth.peak = energy / (2.0 * std::numbers::pi * truth.core_sigma_px * truth.core_sigma_px);
  truth.visible = inside(sight->at, raw_.size());
  const double halo_energy = energy * light.halo_share * light.halo_widening * light.halo_widening;
  add_gaussian(light, truth, truth.core_sigma_px, energy_of(light, energy));
  add_gaussian(light, truth, light.halo_widening * truth.core_sigma_px, energy_of(light, halo_energy));
  return truth;
}

/// Adds the spot at evenly spaced instants of the exposure.
void FrameRenderer::add_gaussian(const LightSource& light, const LightTruth& truth, double sigma,
                                 const LinearColor& energy) {
  const SimulationSettings& settings = world_.settings();
  const Duration middle = truth.exposed_since_1970;
  const std::optional<Sight> before = sight_of(light, middle - kVelocityStep);
  const std::optional<Sight> after = sight_of(light, middle + kVelocityStep);
  if (!before || !after) return;
  const Vec2 velocity_px_per_s =
      Vec2(after->at.u_px - before->at.u_px, after->at.v_px - before->at.v_px) / seconds(2 * kVelocityStep);
  const double path_px = velocity_px_per_s.norm() * seconds(settings.exposure);
  const int steps = static_cast<int>(
      std::clamp(std::ceil(kStepsPerSigma * path_px / sigma), 1.0, static_cast<double>(kMaxBlurSteps)));
  const LinearColor share{energy[0] / steps, energy[1] / steps, energy[2] / steps};
  for (int i = 0; i < steps; ++i) {
    const Duration offset = duration_from_seconds(seconds(settings.exposure) * ((i + 0.5) / steps - 0.5));
    const std::optional<Sight> sight = sight_of(light, middle + offset);
    if (!sight) continue;
    light_.add({.at = sight->at,
                .sigma_px = sigma,
                .energy = share,
                .row_px = truth.at.v_px,
                .shift_px_per_row = velocity_px_per_s * seconds(settings.line_time)},
               world_.normal());
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
