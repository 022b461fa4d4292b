// How fast tags are followed between decodes, and how well, in rendered pictures of three moving tags with known truth;
// against libapriltag as it comes. Figures on stdout, a table of times on stderr.
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "bench/figure.h"
#include "bench/interleaved.h"
#include "sim/renderer.h"
#include "sim/world.h"
#include "tags/tag_points.h"
#include "tags/tag_print.h"
#include "tags/tag_tracker.h"

namespace tripoint::bench {
namespace {

constexpr std::array<int, 3> kIds{0, 1, 2};
constexpr double kSize_mm = 32.0;  // 50 px at 400 mm
constexpr std::size_t kTimed = 60;
constexpr std::size_t kMeasured = 360;  // once along the paper's half circle and back, at 30 Hz

/// Three tags on a plate that moves as in the paper, before a grey wall. The lenses do not distort: where they do, the
/// line takes it off.
SimulationSettings scene_of(ImageSize size) {
  SimulationSettings settings;
  settings.rig = default_rig(size);
  for (const Side side : kBothSides) settings.rig.cameras[side].distortion = {};
  settings.scene.lights.clear();
  settings.scene.white_level = 0.9;
  settings.format = PixelFormat::kGrey;
  const std::array<Vec3, 3> places_mm{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};
  for (std::size_t i = 0; i < kIds.size(); ++i) {
    Isometry3 placed = Isometry3::Identity();
    placed.translation() = places_mm[i];
    placed.linear() = Vec3(1.0, -1.0, -1.0).asDiagonal();
    settings.scene.tags.push_back({.id = kIds[i],
                                   .cells = tag_print("tag36h11", kIds[i]).value(),
                                   .size_mm = kSize_mm,
                                   .target_from_tag = placed});
  }
  return settings;
}

Picture picture_of(RenderedFrame& rendered, std::size_t number) {
  return {.size = rendered.size,
          .luma = {rendered.pixels.data(), rendered.stride_bytes, 1},
          .u = {},
          .v = {},
          .frame = static_cast<std::uint32_t>(number)};
}

/// As `apriltag_detector_create` makes it: every second pixel, edges refined.
class Library {
 public:
  Library() { apriltag_detector_add_family(detector_.get(), family_.get()); }

  int tags_in(RenderedFrame& rendered) {
    image_u8_t picture{rendered.size.width_px, rendered.size.height_px, static_cast<int>(rendered.stride_bytes),
                       rendered.pixels.data()};
    zarray_t* const found = apriltag_detector_detect(detector_.get(), &picture);
    const int count = zarray_size(found);
    apriltag_detections_destroy(found);
    return count;
  }

 private:
  std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family_{tag36h11_create(), tag36h11_destroy};
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_{apriltag_detector_create(),
                                                                                 apriltag_detector_destroy};
};

struct Errors {
  double squares_px2 = 0.0;
  std::size_t coordinates = 0;
  std::size_t pictures = 0;  ///< that were not decoded

  void take(const SeenTags& seen, const FrameTruth& truth) {
    if (seen.coverage == Coverage::kWholeFrame) return;
    ++pictures;
    for (const SeenTag& tag : seen.tags) {
      const TagTruth& true_tag = truth.tags[static_cast<std::size_t>(tag.decoded.id)];
      for (std::size_t k = 0; k < kTagCorners; ++k) {
        squares_px2 += std::pow(tag.outline.corners_px[k].u_px - true_tag.corners_px[k].u_px, 2) +
                       std::pow(tag.outline.corners_px[k].v_px - true_tag.corners_px[k].v_px, 2);
        coordinates += 2;
      }
    }
  }
  [[nodiscard]] double rms_px() const { return std::sqrt(squares_px2 / static_cast<double>(coordinates)); }
};

TagTracker tracker_of_all() { return TagTracker::open({.ids = {kIds.begin(), kIds.end()}}).value(); }

std::vector<RenderedFrame> rendered_first(const SimulatedWorld& world, std::size_t count) {
  FrameRenderer renderer(world, Side::kLeft);
  std::vector<RenderedFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    frames.push_back(renderer.render(duration_from_seconds(static_cast<double>(i) / 30.0), i));
  }
  return frames;
}

Errors errors_in(const SimulatedWorld& world) {
  FrameRenderer renderer(world, Side::kLeft);
  TagTracker tracker = tracker_of_all();
  Errors errors;
  for (std::size_t i = 0; i < kMeasured; ++i) {
    RenderedFrame rendered = renderer.render(duration_from_seconds(static_cast<double>(i) / 30.0), i);
    errors.take(tracker.see(picture_of(rendered, i)), rendered.truth);
  }
  return errors;
}

struct Times {
  double library_us = 0.0;
  double following_us = 0.0;  ///< a picture between decodes
  double decode_us = 0.0;     ///< one that is decoded
};

/// A tracker that has seen the picture before sees the next one; of it and the points for the line.
Times times_in(std::vector<RenderedFrame>& frames) {
  Library library;
  TagTracker tracker = tracker_of_all();
  TagDetector detector = TagDetector::open({.ids = {kIds.begin(), kIds.end()}}).value();
  constexpr std::size_t kCases = 3;
  std::size_t picture = 0;
  std::size_t seen = 0;
  const auto index = [&](std::size_t number) { return number / kCases % kTimed; };
  const std::vector<double> us = interleaved_medians_us<ProcessorClock>(
      {[&](std::size_t number) { seen += static_cast<std::size_t>(library.tags_in(frames[index(number)])); },
       [&](std::size_t number) {
         const SeenTags& tags = tracker.see(picture_of(frames[index(number)], picture++));
         seen += points_of(tags, kIds).points.size();
       },
       [&](std::size_t number) { seen += detector.detect(picture_of(frames[index(number)], 0)).tags.size(); }},
      4 * kTimed);
  if (seen == 0) std::fputs("no tag was seen\n", stderr);
  return {us[0], us[1], us[2]};
}

void measure(ImageSize size, const char* name, std::vector<Figure>& figures, bool with_goals) {
  const SimulatedWorld world = SimulatedWorld::create(scene_of(size)).value();
  std::vector<RenderedFrame> frames = rendered_first(world, kTimed);
  const Times times = times_in(frames);
  const Errors errors = errors_in(world);
  std::fprintf(
      stderr, "%-9s libapriltag %8.1f us, followed %6.1f us, decoded %8.1f us; rms %.4f px in %zu of %zu pictures\n",
      name, times.library_us, times.following_us, times.decode_us, errors.rms_px(), errors.pictures, kMeasured);
  const double ratio = times.library_us / times.following_us;
  const double cycle_us = (times.decode_us + (kFramesPerWhole - 1) * times.following_us) / kFramesPerWhole;
  const std::string suffix = with_goals ? "" : std::string("_") + name;
  const Figure speed{.name = "tag_tracking" + suffix + "_vs_libapriltag",
                     .value = ratio,
                     .unit = "ratio",
                     .baseline = times.library_us,
                     .ratio = ratio};
  const Figure rms{.name = "tag_tracking" + suffix + "_rms_px", .value = errors.rms_px(), .unit = "px"};
  figures.push_back(with_goals ? at_least(speed, 100.0) : speed);
  figures.push_back(with_goals ? at_most(rms, 0.02) : rms);
  const double cycle = times.library_us / cycle_us;
  figures.push_back({.name = "tag_cycle" + suffix + "_vs_libapriltag",
                     .value = cycle,
                     .unit = "ratio",
                     .baseline = times.library_us,
                     .ratio = cycle});
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  using namespace tripoint::bench;
  std::vector<Figure> figures;
  measure({.width_px = 640, .height_px = 480}, "640x480", figures, true);
  measure({.width_px = 1280, .height_px = 720}, "1280x720", figures, false);
  print(figures);
  return 0;
}
