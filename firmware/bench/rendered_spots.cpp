#include "bench/rendered_spots.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "capture/mjpeg_decoder.h"
#include "line/detect/led_detector.h"
#include "sim/draws.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr int kColumns = 6;
constexpr int kRows = 4;
constexpr double kApart_mm = 60.0;     // 94 px at 640x480
constexpr double kAside_mm = 5.0;      // how far a place is drawn from that of the grid, and the grid from the middle
constexpr double kMaxMiss_px = 3.0;    // a point further from the truth than that is another thing
constexpr double kEllipse_95 = 5.991;  // of chi-square with two degrees of freedom

std::vector<Vec3> drawn_places_mm(std::uint64_t seed) {
  Draws draws(seed, 0);
  std::vector<Vec3> places_mm;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const double x_mm = kApart_mm * (i % kColumns - 0.5 * (kColumns - 1)) + draws.even(-kAside_mm, kAside_mm);
    const double y_mm = kApart_mm * (i / kColumns - 0.5 * (kRows - 1)) + draws.even(-kAside_mm, kAside_mm);
    places_mm.emplace_back(x_mm, y_mm, 0.0);
  }
  return places_mm;
}

/// At rest for a second each time, somewhere else in the next one.
Trajectory leaping(std::uint64_t seed) {
  return {.period = std::chrono::hours{24}, .reference_from_target = [seed](double phase_s) {
            Draws draws(seed, 1 + static_cast<std::uint64_t>(phase_s));
            Isometry3 pose = Isometry3::Identity();
            const double x_mm = draws.even(-kAside_mm, kAside_mm);
            pose.translation() = Vec3(x_mm, draws.even(-kAside_mm, kAside_mm), kPeakDistance_mm);
            return pose;
          }};
}

void add(SpotErrors& errors, const Detection& detection, const FrameTruth& truth) {
  for (const LightTruth& light : truth.lights) {
    ++errors.asked;
    for (const ImagePoint& point : detection.points) {
      const Vec2 error_px(point.at.u_px - light.at.u_px, point.at.v_px - light.at.v_px);
      if (error_px.norm() > kMaxMiss_px) continue;
      errors.found.push_back({error_px, point.covariance_px2});
      break;
    }
  }
}

/// Root of the mean over both axes of all found.
template <typename Square>
double root_mean(const std::vector<SpotError>& found, Square square) {
  double sum = 0.0;
  for (const SpotError& spot : found) sum += square(spot);
  return std::sqrt(sum / (2.0 * static_cast<double>(std::max<std::size_t>(found.size(), 1))));
}

}  // namespace

double SpotError::chi2() const { return error_px.dot(stated_px2.inverse() * error_px); }

double SpotErrors::rms_px() const {
  return root_mean(found, [](const SpotError& spot) { return spot.error_px.squaredNorm(); });
}

double SpotErrors::rms_over_stated() const {
  return root_mean(found, [](const SpotError& spot) { return spot.chi2(); });
}

double SpotErrors::share_in_95() const {
  const auto inside = std::ranges::count_if(found, [](const SpotError& spot) { return spot.chi2() < kEllipse_95; });
  return static_cast<double>(inside) / static_cast<double>(std::max<std::size_t>(found.size(), 1));
}

SimulationSettings one_spot(const SpotPictures& pictures) {
  SimulationSettings settings;
  settings.rig = default_rig(pictures.size);
  settings.scene = led_scene({Vec3::Zero()}, pictures.peak);
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [](double) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation().z() = kPeakDistance_mm;
                           return pose;
                         }};
  settings.sensor = pictures.sensor;
  settings.format = pictures.format;
  settings.mjpeg_sampling = pictures.sampling;
  settings.mjpeg_quality = pictures.quality;
  return settings;
}

SpotErrors spot_errors(const SpotPictures& pictures, int count, std::uint64_t seed,
                       const LedDetectorSettings& detector_settings) {
  SimulationSettings settings = one_spot(pictures);
  settings.scene.lights = led_scene(drawn_places_mm(seed), pictures.peak).lights;
  settings.trajectory = leaping(seed);
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  FrameRenderer renderer(world, Side::kLeft);
  MjpegDecoder decoder;
  LedDetector detector{detector_settings};
  SpotErrors errors;
  for (int i = 0; i < count; ++i) {
    const RenderedFrame& rendered = renderer.render(duration_from_seconds(i + 0.5), static_cast<std::uint64_t>(i));
    const Frame frame = frame_of(rendered);
    const bool packed = frame.format == PixelFormat::kMjpeg;
    const Picture picture = packed ? decoder.decode(frame.data, frame.size).value() : picture_of(frame);
    add(errors, detector.detect(picture, {}), rendered.truth);
  }
  return errors;
}

}  // namespace tripoint::bench
