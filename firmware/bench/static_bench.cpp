// Static error of one LED over the working volume, from rendered frames through the detector to a point in space.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bench/drawn_calibration.h"
#include "bench/figure.h"
#include "bench/luma_bound.h"
#include "geometry/triangulation.h"
#include "line/detect/led_detector.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr double kBound_px = 0.05;
constexpr std::size_t kAveraged = 30;  // frames of an average
constexpr std::size_t kAverages = 4;   // at each place: of a single one, chance alone moves the figure by 5 %
constexpr int kCalibrations = 24;
constexpr double kBorder_px = 12.0;  // six sigma of a spot: seen whole
constexpr double kMaxMiss_px = 2.0;  // a spot further from the truth than that is another thing
constexpr double kLedPeak = 1.0;     // red just reaches clip

struct Setup {
  std::string name;
  double baseline_mm;
  double toe_in_deg;      ///< of each camera
  double calibration_mm;  ///< RMS of the error field, mathematics.md
  double goal_single_mm;
  double goal_average_mm;
};

/// The lenses of the default rig, mounted the setup's way, with the small tilts of a real mounting.
StereoCalibration calibration_of_setup(const Setup& setup) {
  const double toe_rad = setup.toe_in_deg * std::numbers::pi / 180.0;
  Isometry3 world_from_left = Isometry3::Identity();
  world_from_left.translate(Vec3(-setup.baseline_mm / 2.0, 0.0, 0.0));
  world_from_left.rotate(Eigen::AngleAxisd(toe_rad, Vec3::UnitY()));
  Isometry3 world_from_right = Isometry3::Identity();
  world_from_right.translate(Vec3(setup.baseline_mm / 2.0, 0.0, 0.3));
  world_from_right.rotate(Eigen::AngleAxisd(-toe_rad, Vec3::UnitY()));
  world_from_right.rotate(Eigen::AngleAxisd(0.007, Vec3::UnitX()));
  world_from_right.rotate(Eigen::AngleAxisd(0.012, Vec3::UnitZ()));
  StereoCalibration calibration = default_rig();
  calibration.right_from_left = world_from_right.inverse() * world_from_left;
  return calibration;
}

bool seen_whole(const Rig& rig, const Vec3& place_mm) {
  return std::ranges::all_of(kBothSides, [&](Side side) {
    const CameraModel& camera = rig.cameras[side];
    const Result<RawPixel> at = projected(camera, rig.camera_from_rig[side] * place_mm);
    return at && std::min(at->u_px, at->v_px) > kBorder_px && at->u_px < camera.size.width_px - 1.0 - kBorder_px &&
           at->v_px < camera.size.height_px - 1.0 - kBorder_px;
  });
}

/// The middles of 6 x 6 x 5 equal cells of 300 x 300 x 200 mm around 400 mm, those that both cameras see: their mean
/// is that over the volume.
std::vector<Vec3> places_in_volume(const Rig& rig) {
  std::vector<Vec3> places;
  for (int i = 0; i < 180; ++i) {
    const Vec3 place_mm(50.0 * (i % 6 - 2.5), 50.0 * (i / 6 % 6 - 2.5), 400.0 + 40.0 * (i / 36 - 2));
    if (seen_whole(rig, place_mm)) places.push_back(place_mm);
  }
  return places;
}

Trajectory standing_at(const Vec3& place_mm) {
  return {.period = std::chrono::seconds{1}, .reference_from_target = [place_mm](double) {
            Isometry3 pose = Isometry3::Identity();
            pose.translation() = place_mm;
            return pose;
          }};
}

std::optional<MeasuredPixel> spot_near(const Detection& detection, const RawPixel& truth) {
  for (const ImagePoint& point : detection.points) {
    if (std::hypot(point.at.u_px - truth.u_px, point.at.v_px - truth.v_px) < kMaxMiss_px) {
      return MeasuredPixel{.at = point.at, .covariance_px2 = point.covariance_px2};
    }
  }
  return std::nullopt;
}

using SeenPair = PerSide<std::optional<MeasuredPixel>>;

/// What the detector made of frames of a LED that stands still.
struct Place {
  PerSide<RawPixel> truth;
  std::vector<SeenPair> frames;
};

Place seen_at(const SimulatedWorld& world, std::uint64_t first_number, LedDetector& detector) {
  Place place;
  place.frames.resize(kAverages * kAveraged);
  for (const Side side : kBothSides) {
    FrameRenderer renderer(world, side);
    std::uint64_t number = first_number;
    for (SeenPair& seen : place.frames) {
      const RenderedFrame& frame = renderer.render(Duration{0}, number++);
      place.truth[side] = frame.truth.lights[0].at;
      seen[side] = spot_near(detector.detect(picture_of(frame_of(frame)), {}), place.truth[side]);
    }
  }
  return place;
}

std::vector<Place> seen_at(const std::vector<Vec3>& places_mm, SimulationSettings settings) {
  std::vector<Place> seen;
  LedDetector detector{LedDetectorSettings{}};
  for (const Vec3& place_mm : places_mm) {
    settings.trajectory = standing_at(place_mm);
    const SimulatedWorld world = SimulatedWorld::create(settings).value();
    seen.push_back(seen_at(world, seen.size() * kAverages * kAveraged, detector));
  }
  return seen;
}

/// Errors in the picture, over both axes of all spots.
struct PixelError {
  int asked = 0;
  int found = 0;
  double rms_px = 0.0;
  double bias_px = 0.0;  ///< RMS over the places of what no average takes away
};

PixelError pixel_error_of(const std::vector<Place>& places) {
  PixelError error;
  double squares_px2 = 0.0;
  double bias_px2 = 0.0;
  for (const Place& place : places) {
    for (const Side side : kBothSides) {
      std::array<Vec2, kAverages> means_px;
      means_px.fill(Vec2::Zero());
      for (std::size_t i = 0; i < place.frames.size(); ++i) {
        ++error.asked;
        const std::optional<MeasuredPixel>& spot = place.frames[i][side];
        if (!spot) continue;
        ++error.found;
        const Vec2 off_px(spot->at.u_px - place.truth[side].u_px, spot->at.v_px - place.truth[side].v_px);
        squares_px2 += off_px.squaredNorm();
        means_px[i / kAveraged] += off_px / static_cast<double>(kAveraged);
      }
      // Noise of two averages does not correlate: the mean of their products is the bias alone.
      Vec2 sum_px = Vec2::Zero();
      double own_px2 = 0.0;
      for (const Vec2& mean_px : means_px) sum_px += mean_px, own_px2 += mean_px.squaredNorm();
      bias_px2 += (sum_px.squaredNorm() - own_px2) / (kAverages * (kAverages - 1));
    }
  }
  error.rms_px = std::sqrt(squares_px2 / (2.0 * error.found));
  error.bias_px = std::sqrt(std::max(0.0, bias_px2) / (4.0 * static_cast<double>(places.size())));
  return error;
}

struct StaticError {
  double single_mm = 0.0;
  double average_mm = 0.0;
};

/// RMS over all places, calibrations and frames; after the rigid motion of registration.
StaticError error_of(const std::vector<Place>& places, const std::vector<Vec3>& places_mm,
                     const std::vector<DrawnCalibration>& calibrations) {
  double single_mm2 = 0.0;
  double average_mm2 = 0.0;
  double singles = 0.0;
  double averages = 0.0;
  for (const DrawnCalibration& drawn : calibrations) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::array<Vec3, kAverages> sums_mm;
      sums_mm.fill(Vec3::Zero());
      std::array<double, kAverages> counts{};
      for (std::size_t frame = 0; frame < places[i].frames.size(); ++frame) {
        const SeenPair& seen = places[i].frames[frame];
        if (!seen.left || !seen.right) continue;
        const Result<TriangulatedPoint> point = triangulated(drawn.rig, {*seen.left, *seen.right});
        if (!point) continue;
        const Vec3 error_mm = drawn.truth_from_drawn * point->in_rig_mm - places_mm[i];
        single_mm2 += error_mm.squaredNorm();
        sums_mm[frame / kAveraged] += error_mm;
        counts[frame / kAveraged] += 1.0;
      }
      for (std::size_t k = 0; k < kAverages; ++k) {
        if (counts[k] == 0.0) continue;
        singles += counts[k];
        average_mm2 += (sums_mm[k] / counts[k]).squaredNorm();
        averages += 1.0;
      }
    }
  }
  return {.single_mm = std::sqrt(single_mm2 / singles), .average_mm = std::sqrt(average_mm2 / averages)};
}

/// Settings whose noise makes the bound of the spot's place kBound_px at the centre of the volume.
SimulationSettings settings_with_bound(const StereoCalibration& calibration) {
  SimulationSettings settings;
  settings.rig = calibration;
  settings.scene = led_scene({Vec3::Zero()}, kLedPeak);
  settings.trajectory = standing_at({0.0, 0.0, 400.0});
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  const LightTruth spot = render(world, Side::kLeft, Duration{0}).truth.lights[0];
  const LinearColor background = wall_level(settings.scene);
  settings.sensor = sensor_with_bound(kBound_px, spot, settings.scene.lights[0], background);
  std::fprintf(stderr, "sensor: read noise %.4f of clip, clip at %.0f electrons, spot sigma %.2f px, bound %.4f px\n",
               settings.sensor.read_noise, settings.sensor.full_well_electrons, spot.core_sigma_px,
               luma_bound_px(settings.sensor, spot, settings.scene.lights[0], background));
  return settings;
}

std::vector<Figure> figures_of(const Setup& setup) {
  const StereoCalibration truth = calibration_of_setup(setup);
  const std::vector<Vec3> places_mm = places_in_volume(rig_of(truth).value());
  const RigCovariance covariance = adjustment_covariance(truth, kBound_px, 1);
  const std::vector<DrawnCalibration> calibrations =
      drawn_calibrations(truth, covariance, places_mm, setup.calibration_mm, kCalibrations);
  const std::vector<Place> places = seen_at(places_mm, settings_with_bound(truth));
  const PixelError in_picture = pixel_error_of(places);
  const StaticError error = error_of(places, places_mm, calibrations);
  std::fprintf(
      stderr, "%s: %zu places, %d of %d spots found, %.4f px RMS per axis, of which %.4f px never average out\n",
      setup.name.c_str(), places_mm.size(), in_picture.found, in_picture.asked, in_picture.rms_px, in_picture.bias_px);
  return {at_most({.name = "static_rms_mm_" + setup.name + "_1", .value = error.single_mm, .unit = "mm"},
                  setup.goal_single_mm),
          at_most({.name = "static_rms_mm_" + setup.name + "_30", .value = error.average_mm, .unit = "mm"},
                  setup.goal_average_mm)};
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  using tripoint::bench::Figure;
  std::vector<Figure> all;
  for (const tripoint::bench::Setup& setup : {tripoint::bench::Setup{"b100", 100.0, 5.0, 0.032, 0.25, 0.06},
                                              tripoint::bench::Setup{"b200", 200.0, 12.0, 0.014, 0.13, 0.03}}) {
    const std::vector<Figure> figures = figures_of(setup);
    all.insert(all.end(), figures.begin(), figures.end());
  }
  print(all);
}
