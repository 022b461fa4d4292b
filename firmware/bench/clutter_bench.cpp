// How many LEDs the detector finds in cluttered stereo scenes, and what it believes to be one.
//
// usage: bench_clutter [--scenes N] [--first-seed S] [--row NAME] [--list]
// A table on stderr, one row for each kind of scene; its figures on stdout. --list names each miss, each
// LED that lies beyond three stated deviations and each false point; tripoint-render --scenario clutter --seed S draws
// the same picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/clutter_scoring.h"
#include "bench/figure.h"
#include "capture/mjpeg_decoder.h"
#include "line/model.h"
#include "sim/clutter.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

struct Options {
  std::uint64_t scenes = 150;
  std::uint64_t first_seed = 1;
  std::string row;  ///< empty: all
  bool list = false;
};

struct Row {
  std::string name;
  ClutterChoice choice{};
  PixelFormat format = PixelFormat::kYuyv;
  ChromaSampling sampling = ChromaSampling::k422;
  int quality = 85;
  bool toned = false;
};

struct Tally {
  int scenes = 0;
  int asked = 0;
  int found = 0;
  int covered = 0;
  int in_95 = 0;
  double squares_px2 = 0.0;
  double stated_px2 = 0.0;
  std::map<std::string, int> misses;  ///< by cause
  std::array<int, kCompanyNames.size()> missed_in{};
  std::map<Origin, int> false_points;  ///< in single views
  PairCounts pairs;

  [[nodiscard]] double found_share() const { return found / std::max(1.0, asked * 1.0); }
  [[nodiscard]] double of_found(int leds) const { return leds / std::max(1.0, found * 1.0); }
};

/// A detector and a decoder for each camera, as in the unit.
class Eyes {
 public:
  ViewScore look(const RenderedFrame& frame, const SimulatedWorld& world) {
    const Frame raw = frame_of(frame);
    const Picture picture =
        frame.format == PixelFormat::kMjpeg ? decoder_.decode(raw.data, raw.size).value() : picture_of(raw);
    const Detection detection = detector_.detect(picture, {});
    return view_score(detection, detector_.candidates(), frame.truth, world);
  }

 private:
  MjpegDecoder decoder_;
  LedDetector detector_{LedDetectorSettings{}};
};

/// The names are literals, which end with a zero.
template <typename Names, typename Value>
const char* text(const Names& names, Value value) {
  return names[static_cast<std::size_t>(value)].data();
}

void list(const Row& row, std::uint64_t seed, Side side, const ViewScore& view) {
  const auto where = [&](const char* what, const RawPixel& at) {
    std::fprintf(stderr, "%s seed %llu %s (%.1f, %.1f) %s", row.name.c_str(), static_cast<unsigned long long>(seed),
                 std::string(name(side)).c_str(), at.u_px, at.v_px, what);
  };
  for (const LedScore& led : view.leds) {
    if (led.found && !led.covered) {
      where("misplaced", led.at);
      std::fprintf(stderr, " %.3f px, stated %.3f px per axis, %s\n", led.error_px, led.stated_px,
                   text(kCompanyNames, led.company));
    }
    if (led.found) continue;
    where("missed", led.at);
    std::fprintf(stderr, " %s, %s, peak %.2f\n", led.cause.c_str(), text(kCompanyNames, led.company), led.peak);
  }
  for (const PointScore& point : view.points) {
    if (point.origin == Origin::kLed) continue;
    where("false", point.at);
    std::fprintf(stderr, " %s\n", text(kOriginNames, point.origin));
  }
}

void count(Tally& tally, const ViewScore& view) {
  for (const LedScore& led : view.leds) {
    ++tally.asked;
    if (!led.found) {
      ++tally.misses[led.cause];
      ++tally.missed_in[static_cast<std::size_t>(led.company)];
      continue;
    }
    ++tally.found;
    tally.covered += led.covered ? 1 : 0;
    tally.in_95 += led.in_95 ? 1 : 0;
    tally.squares_px2 += led.error_px * led.error_px;
    tally.stated_px2 += led.stated_px * led.stated_px;
  }
  for (const PointScore& point : view.points) {
    if (point.origin != Origin::kLed) ++tally.false_points[point.origin];
  }
}

Tally tally_of(const Row& row, const Options& options) {
  Tally tally;
  PerSide<Eyes> eyes;
  for (std::uint64_t seed = options.first_seed; seed < options.first_seed + options.scenes; ++seed) {
    SimulationSettings settings = clutter_settings(seed, row.choice);
    settings.format = row.format;
    settings.mjpeg_sampling = row.sampling;
    settings.mjpeg_quality = row.quality;
    if (row.toned) settings.tone = webcam_tone();
    const SimulatedWorld world = SimulatedWorld::create(settings).value();
    PerSide<ViewScore> views;
    for (const Side side : kBothSides) {
      views[side] = eyes[side].look(render(world, side, Duration{0}), world);
      count(tally, views[side]);
      if (options.list) list(row, seed, side, views[side]);
    }
    const PairCounts pairs = pair_counts(clutter_model(settings), views);
    tally.pairs.leds += pairs.leds;
    tally.pairs.ghosts += pairs.ghosts;
    tally.pairs.red_lights += pairs.red_lights;
    tally.pairs.others += pairs.others;
    ++tally.scenes;
  }
  return tally;
}

/// Every size in every format, then what is harder.
std::vector<Row> rows() {
  std::vector<Row> all;
  for (const ImageSize size : {ImageSize{640, 480}, ImageSize{320, 240}, ImageSize{1280, 720}}) {
    Row row{.name = std::to_string(size.width_px)};
    row.choice.size = size;
    const std::string prefix = row.name;
    row.name = prefix + "_yuyv";
    all.push_back(row);
    row.format = PixelFormat::kMjpeg;
    row.name = prefix + "_422_q85";
    all.push_back(row);
    row.sampling = ChromaSampling::k420;
    row.quality = 70;
    row.name = prefix + "_420_q70";
    all.push_back(row);
  }
  Row row{.name = "640_yuyv_toned"};
  row.toned = true;
  all.push_back(row);
  row = {.name = "640_yuyv_red_lamps"};
  row.choice.red_lamp_probability = 1.0;
  all.push_back(row);
  for (const double white : {0.1, 0.2, 0.4, 0.8}) {
    char name[32];
    std::snprintf(name, sizeof name, "640_yuyv_white_%g", white);
    row = {.name = name};
    row.choice.white_level = {white, white};
    all.push_back(row);
  }
  row = {.name = "640_yuyv_all_exposures"};
  row.choice.white_level = {0.01, 1.2};
  row.choice.led_peak = {0.4, 100.0};
  all.push_back(row);
  return all;
}

void print_row(const Row& row, const Tally& tally) {
  const auto of = [&](Origin origin) {
    const auto found = tally.false_points.find(origin);
    return (found == tally.false_points.end() ? 0.0 : found->second) / (2.0 * tally.scenes);
  };
  std::fprintf(stderr, "%-24s %5d %6.4f %7.4f %7.4f %6.4f %6.4f | %6.3f %6.3f %6.3f %6.3f %6.3f | %5d %5d %5d %5d |",
               row.name.c_str(), tally.asked, tally.found_share(), tally.of_found(tally.in_95),
               tally.of_found(tally.covered), std::sqrt(tally.squares_px2 / std::max(1.0, 2.0 * tally.found)),
               std::sqrt(tally.stated_px2 / std::max(1.0, 1.0 * tally.found)), of(Origin::kRedLamp),
               of(Origin::kReflection), of(Origin::kOtherLight), of(Origin::kHotPixel), of(Origin::kThing),
               tally.pairs.leds, tally.pairs.ghosts, tally.pairs.red_lights, tally.pairs.others);
  for (std::size_t i = 0; i < kCompanyNames.size(); ++i)
    std::fprintf(stderr, " %*d", i == 0 ? 5 : 6, tally.missed_in[i]);
  std::fputs(" |", stderr);
  for (const auto& [cause, times] : tally.misses) std::fprintf(stderr, " %s %d", cause.c_str(), times);
  std::fputc('\n', stderr);
}

/// The goal is the first row's: 640x480 YUYV. The others are called after their row.
void add_figures(std::vector<Figure>& figures, const std::string& row, const Tally& tally) {
  const std::string of_row = figures.empty() ? "" : "_" + row;
  const Figure found{.name = "clutter_leds_found_share" + of_row, .value = tally.found_share(), .unit = "share"};
  figures.push_back({.name = "clutter_covered_share" + of_row, .value = tally.of_found(tally.in_95), .unit = "share"});
  const double false_points = tally.pairs.red_lights + tally.pairs.others;
  figures.push_back(figures.empty() ? at_least(found, 0.97) : found);
  figures.push_back(
      {.name = "clutter_false_points" + of_row, .value = false_points / tally.scenes, .unit = "per scene"});
  figures.push_back({.name = "clutter_ghost_points" + of_row,
                     .value = static_cast<double>(tally.pairs.ghosts) / tally.scenes,
                     .unit = "per scene"});
}

int run(const Options& options) {
  std::fprintf(
      stderr,
      "%-24s %5s %6s %7s %7s %6s %6s | false points a view                | stereo pairs            | misses           "
      "   "
      "|\n"
      "%-24s %5s %6s %7s %7s %6s %6s | %6s %6s %6s %6s %6s | %5s %5s %5s %5s | alone beside outsh. | misses by cause\n",
      "", "LEDs", "found", "in 95 %", "in 3 s.", "RMS px", "stated", "", "", "", "", "", "", "", "lamp", "mirror",
      "light", "hot px", "thing", "LED", "ghost", "red", "other");
  std::vector<Figure> figures;
  for (const Row& row : rows()) {
    if (!options.row.empty() && options.row != row.name) continue;
    const Tally tally = tally_of(row, options);
    print_row(row, tally);
    add_figures(figures, row.name, tally);
  }
  if (figures.empty()) std::fprintf(stderr, "no row %s\n", options.row.c_str());
  print(figures);
  return figures.empty() ? 2 : 0;
}

/// Nothing when an argument is unknown or has no value.
std::optional<Options> options_of(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--list") {
      options.list = true;
      continue;
    }
    if (i + 1 == arguments.size()) return std::nullopt;
    const std::string& name = arguments[i];
    const std::string& value = arguments[++i];
    if (name == "--scenes")
      options.scenes = std::stoull(value);
    else if (name == "--first-seed")
      options.first_seed = std::stoull(value);
    else if (name == "--row")
      options.row = value;
    else
      return std::nullopt;
  }
  return options;
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  const auto options = tripoint::bench::options_of({argv + 1, argv + argc});
  if (options) return tripoint::bench::run(*options);
  std::fputs("usage: bench_clutter [--scenes N] [--first-seed S] [--row NAME] [--list]\n", stderr);
  return 2;
}
