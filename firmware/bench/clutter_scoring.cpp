#include "bench/clutter_scoring.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangulation.h"
#include "line/match/epipolar.h"

namespace tripoint::bench {
namespace {

constexpr double kFoundWithin_px = 1.0;
constexpr double kSigmas = 3.0;
constexpr double kSigmas_95 = 2.4477;  // root of 5.991, the 95 % of chi-square with two degrees of freedom
constexpr double kSeenShare = 0.9;     // of an LED's light, above which it is to be found
constexpr double kBesideShare = 0.1;   // of an LED's peak, below which another light does not disturb it
constexpr double kShowsShare = 0.05;   // of a light, below which no point is about it
constexpr double kSameThing_px = 2.0;  // a point this close to a light, or within two of its sigma, shows that light
constexpr double kLookedAt_px = 3.0;   // a candidate this close to an LED, or within three of its sigma, is about it
constexpr double kNearest_mm = 250.0;
constexpr double kFarthest_mm = 1000.0;
constexpr double kOffsetPrior_s = 100e-6;

double distance_px(const RawPixel& a, const RawPixel& b) { return std::hypot(a.u_px - b.u_px, a.v_px - b.v_px); }

double stated_sigmas(const ImagePoint& point, const RawPixel& truth) {
  const Vec2 error_px(point.at.u_px - truth.u_px, point.at.v_px - truth.v_px);
  return std::sqrt(error_px.dot(point.covariance_px2.inverse() * error_px));
}

bool is_to_be_found(const LightTruth& light, double elongation, ImageSize size) {
  const double margin_px = kSigmas * light.core_sigma_px * std::sqrt(elongation);
  return light.id != 0 && light.visible && light.visible_share >= kSeenShare && light.at.u_px > margin_px &&
         light.at.v_px > margin_px && light.at.u_px < size.width_px - 1.0 - margin_px &&
         light.at.v_px < size.height_px - 1.0 - margin_px;
}

Company company_of(const FrameTruth& truth, const Scene& scene, const LightTruth& led) {
  double others_red = 0.0;
  bool beside = false;
  for (std::size_t i = 0; i < truth.lights.size(); ++i) {
    const LightTruth& light = truth.lights[i];
    if (&light == &led || light.core_sigma_px == 0.0) continue;
    const double away_px = distance_px(light.at, led.at);
    const double red = light.peak * light.visible_share * scene.lights[i].color[0];
    others_red += red * std::exp(-0.5 * std::pow(away_px / light.core_sigma_px, 2));
    beside =
        beside || (red >= kBesideShare * led.peak && away_px < kSigmas * (light.core_sigma_px + led.core_sigma_px));
  }
  if (others_red >= 1.0) return Company::kOutshone;
  return beside ? Company::kBeside : Company::kAlone;
}

/// The gates stand in the order of the causes: the largest came furthest.
std::string cause_of_miss(const CandidateLog& candidates, const LightTruth& light) {
  const double reach_px = std::max(kLookedAt_px, 3.0 * light.core_sigma_px);
  bool looked_at = false;
  DropCause furthest = DropCause::kSeenBefore;
  for (const Candidate& candidate : candidates) {
    const RawPixel start{static_cast<double>(candidate.start_u_px), static_cast<double>(candidate.start_v_px)};
    if (std::min(distance_px(candidate.at, light.at), distance_px(start, light.at)) > reach_px) continue;
    if (candidate.cause == DropCause::kKept) return "off";
    looked_at = true;
    furthest = std::max(furthest, candidate.cause);
  }
  return looked_at ? std::string(name(furthest)) : "not_looked_at";
}

LedScore led_score(const Detection& detection, const CandidateLog& candidates, const LightTruth& light) {
  LedScore score{.id = light.id, .at = light.at, .peak = light.peak};
  score.error_px = std::numeric_limits<double>::infinity();
  for (const ImagePoint& point : detection.points) {
    const double error_px = distance_px(point.at, light.at);
    const double sigmas = stated_sigmas(point, light.at);
    if (error_px >= score.error_px || (error_px > kFoundWithin_px && sigmas > kSigmas)) continue;
    score.found = true;
    score.covered = sigmas <= kSigmas;
    score.in_95 = sigmas <= kSigmas_95;
    score.stated_px = std::sqrt(0.5 * point.covariance_px2.trace());
    score.error_px = error_px;
  }
  if (!score.found) score.cause = cause_of_miss(candidates, light);
  return score;
}

Origin origin_of(const LightTruth& truth, const LightSource& light) {
  if (truth.id != 0) return Origin::kLed;
  if (light.mirror) return Origin::kReflection;
  return light.color[1] < 0.2 ? Origin::kRedLamp : Origin::kOtherLight;
}

bool on_hot_pixel(const RawPixel& at, const std::vector<std::size_t>& hot_pixels, ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width_px);
  return std::ranges::any_of(hot_pixels, [&](std::size_t pixel) {
    const RawPixel hot{static_cast<double>(pixel % width), static_cast<double>(pixel / width)};
    return distance_px(at, hot) <= kSameThing_px;
  });
}

/// LEDs first, then red lights: where two lights lie together, the point shows the one it may show.
PointScore point_score(const ImagePoint& point, const FrameTruth& truth, const SimulatedWorld& world) {
  PointScore score{.at = point.at, .pixel = {.at = point.at, .covariance_px2 = point.covariance_px2}};
  const SimulationSettings& settings = world.settings();
  if (on_hot_pixel(point.at, world.hot_pixels(truth.side), settings.rig.cameras[truth.side].size)) {
    score.origin = Origin::kHotPixel;
  }
  for (std::size_t i = 0; i < truth.lights.size(); ++i) {
    const LightTruth& light = truth.lights[i];
    const double reach_px = std::max(kSameThing_px, 2.0 * light.core_sigma_px);
    if (!light.visible || light.visible_share < kShowsShare || distance_px(point.at, light.at) > reach_px) continue;
    const Origin origin = origin_of(light, settings.scene.lights[i]);
    if (origin >= score.origin) continue;
    score.origin = origin;
    score.led = light.id;
  }
  return score;
}

}  // namespace

ViewScore view_score(const Detection& detection, const CandidateLog& candidates, const FrameTruth& truth,
                     const SimulatedWorld& world) {
  ViewScore score;
  const SimulationSettings& settings = world.settings();
  const ImageSize size = settings.rig.cameras[truth.side].size;
  for (std::size_t i = 0; i < truth.lights.size(); ++i) {
    const LightTruth& light = truth.lights[i];
    if (is_to_be_found(light, settings.scene.lights[i].elongation, size)) {
      score.leds.push_back(led_score(detection, candidates, light));
      score.leds.back().company = company_of(truth, settings.scene, light);
    }
  }
  for (const ImagePoint& point : detection.points) score.points.push_back(point_score(point, truth, world));
  return score;
}

LineModel clutter_model(const SimulationSettings& scene) {
  LineModel model;
  model.calibration = scene.rig;
  model.rig = rig_of(scene.rig).value();
  model.limits.offset_prior_s = kOffsetPrior_s;
  model.target.facing = -Vec3::UnitZ();  // as the scenes have it
  for (const LightSource& light : scene.scene.lights) {
    if (light.id != 0) model.target.points.push_back({light.id, light.place_mm, 0.0});
  }
  return model;
}

PairCounts pair_counts(const LineModel& model, const PerSide<ViewScore>& views) {
  PairCounts counts;
  for (const PointScore& left : views.left.points) {
    for (const PointScore& right : views.right.points) {
      const PerSide<MeasuredPixel> pixels{left.pixel, right.pixel};
      const std::optional<EpipolarGate> gate = epipolar_gate(model, pixels);
      if (!gate || !gate->passed) continue;
      const Result<TriangulatedPoint> point = triangulated(model.rig, pixels);
      if (!point || point->in_rig_mm.z() < kNearest_mm || point->in_rig_mm.z() > kFarthest_mm) continue;
      const Origin worst = std::max(left.origin, right.origin);
      if (worst > Origin::kReflection)
        ++counts.others;
      else if (worst > Origin::kLed)
        ++counts.red_lights;
      else
        ++(left.led == right.led ? counts.leds : counts.ghosts);
    }
  }
  return counts;
}

}  // namespace tripoint::bench
