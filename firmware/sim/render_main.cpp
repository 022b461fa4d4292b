// tripoint-render: one period of a simulated motion, or a cluttered scene, as a recording folder.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "sim/clutter.h"
#include "sim/rendered_recording.h"
#include "sim/world.h"

namespace tripoint {
namespace {

constexpr int kWell = 0;
constexpr int kUsage = 2;
constexpr int kOurFault = 70;

struct Options {
  int frames = 0;
  std::string out;
  std::string format = "yuyv";
  std::string scenario = "paper-circular";
  std::string trajectory;
  int width_px = 640;
  int height_px = 480;
  std::optional<int> leds;
  std::optional<double> led_peak;
  double white_level = 0.05;
  bool red_lamps = false;
  std::vector<double> datum_mm;  // none, or x, y, z
  std::string tone = "linear";
  std::optional<double> read_noise;
  double target_scale = 1.0;
  int exposure_us = 5000;
  int quality = 90;
  std::uint64_t seed = 1;
};

/// A scalene triangle of 100, 80 and 60 mm times `scale`; a single LED is the target's origin.
std::vector<Vec3> led_places(int leds, double scale) {
  if (leds == 1) return {Vec3::Zero()};
  return {Vec3(0.0, 0.0, 0.0), Vec3(100.0 * scale, 0.0, 0.0), Vec3(64.0 * scale, 48.0 * scale, 0.0)};
}

Result<Trajectory> chosen_trajectory(const Options& options) {
  return options.trajectory.empty() ? scenario_trajectory(options.scenario) : load_trajectory(options.trajectory);
}

ImageSize size_of(const Options& options) { return {.width_px = options.width_px, .height_px = options.height_px}; }

/// LEDs in motion before a wall.
Result<SimulationSettings> open_scene(const Options& options) {
  Result<Trajectory> trajectory = chosen_trajectory(options);
  if (!trajectory) return tl::make_unexpected(trajectory.error());
  SimulationSettings settings;
  settings.trajectory = *trajectory;
  if (options.trajectory.empty() && options.scenario == "bumped-camera") settings.knock = bumped_camera();
  settings.scene =
      led_scene(led_places(options.leds.value_or(1), options.target_scale), options.led_peak.value_or(1.5));
  if (const std::vector<double>& at = options.datum_mm; !at.empty()) {
    settings.scene.lights.push_back(fixed_lamp(settings.scene, {at[0], at[1], at[2]}));
  }
  settings.scene.white_level = options.white_level;
  settings.rig = default_rig(size_of(options));
  settings.seed = options.seed;
  return settings;
}

SimulationSettings cluttered_scene(const Options& options) {
  ClutterChoice choice{.size = size_of(options), .white_level = {options.white_level, options.white_level}};
  choice.red_lamp_probability = options.red_lamps ? 1.0 : 0.0;
  if (options.leds) choice.min_leds = choice.max_leds = *options.leds;
  if (options.led_peak) choice.led_peak = {*options.led_peak, *options.led_peak};
  return clutter_settings(options.seed, choice);
}

/// The frames share the period out evenly, so that the recording can be played round and round.
Result<void> render_recording(const Options& options) {
  const bool cluttered = options.scenario == "clutter" && options.trajectory.empty();
  Result<SimulationSettings> settings = cluttered ? cluttered_scene(options) : open_scene(options);
  if (!settings) return tl::make_unexpected(settings.error());
  settings->format = options.format == "jpg" ? PixelFormat::kMjpeg : PixelFormat::kYuyv;
  settings->mjpeg_quality = options.quality;
  if (options.tone == "webcam") settings->tone = webcam_tone();
  settings->sensor.read_noise = options.read_noise.value_or(settings->sensor.read_noise);
  settings->exposure = std::chrono::microseconds{options.exposure_us};
  settings->rate_hz = options.frames / seconds(settings->trajectory.period);
  return SimulatedWorld::create(*settings, TimePoint{settings->trajectory.period})
      .and_then(
          [&](const SimulatedWorld& world) { return write_rendered_recording(world, options.frames, options.out); });
}

void complain(const std::string& message) {
  static_cast<void>(std::fprintf(stderr, "tripoint-render: %s\n", message.c_str()));
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Renders one period of a simulated motion, seen by two cameras, as a recording folder with its truth.",
               "tripoint-render");
  app.option_defaults()->always_capture_default();
  app.footer(
      "The rate is frames over the period (12 s for the paper's paths): take at least 15 a second.\n"
      "Exit codes: 0 well; 2 usage, or a folder that cannot be written; 70 our fault.\n\n"
      "Example: tripoint-render --frames 360 --out recording --scenario paper-circular --format jpg");
  app.add_option("--frames", options.frames, "frames of each camera; they share the period out evenly")
      ->required()
      ->check(CLI::Range(1, 100'000))
      ->default_str("");
  app.add_option("--out", options.out, "folder to write; must be empty or absent")->required();
  app.add_option("--format", options.format, "yuyv or jpg")->check(CLI::IsMember({"yuyv", "jpg"}));
  app.add_option("--scenario", options.scenario,
                 "paper-linear, paper-circular, scout (periods 12, 12, 6 s), static-volume (81 s), bumped-camera\n"
                 "(36 s: the right camera stands turned by 0.1 degrees in the second of three circles), or clutter:\n"
                 "a still target among things like LEDs, another scene with each seed (12 s)");
  app.add_option("--trajectory", options.trajectory, "CSV file as host-tool simulate writes it, instead of a scenario");
  app.add_option("--width", options.width_px, "of a picture, px: 320, 640 or 1280");
  app.add_option("--height", options.height_px, "of a picture, px: 240, 480 or 720");
  app.add_option("--leds", options.leds, "1, or 3 for a triangle of 100, 80, 60 mm; clutter: 3 or 4 by seed")
      ->check(CLI::IsMember({1, 3}))
      ->default_str("1");
  app.add_option("--target-scale", options.target_scale, "by which the triangle is larger; not with clutter")
      ->check(CLI::Range(0.1, 10.0));
  app.add_option("--led-peak", options.led_peak,
                 "brightness of an LED in units of clip; 1 to 3 is recommended; clutter: 1 to 3 by seed")
      ->check(CLI::Range(0.0, 100.0))
      ->default_str("1.5");
  app.add_option("--white-level", options.white_level, "of a white surface in units of clip; up to 0.06 is recommended")
      ->check(CLI::Range(0.001, 10.0));
  app.add_option("--datum", options.datum_mm, "X Y Z of a fixed LED in the reference frame, mm; not with clutter")
      ->expected(3)
      ->default_str("");
  app.add_flag("--red-lamps", options.red_lamps, "clutter: with one or two lamps like the LEDs");
  app.add_option("--tone", options.tone, "linear, or webcam: a colour matrix and gamma 2.2")
      ->check(CLI::IsMember({"linear", "webcam"}));
  app.add_option("--read-noise", options.read_noise,
                 "standard deviation of the sensor's noise in units of clip; clutter: by seed")
      ->check(CLI::Range(0.0, 0.1))
      ->default_str("0.002");
  app.add_option("--exposure-us", options.exposure_us, "exposure time, us")->check(CLI::Range(0, 1'000'000));
  app.add_option("--quality", options.quality, "of a JPEG, 1 to 100; with --format jpg");
  app.add_option("--seed", options.seed, "of the noise and the clutter: the same seed gives the same pictures");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kWell : kUsage;
  }
  const Result<void> done = render_recording(options);
  if (done) return kWell;
  complain(done.error().message);
  return kUsage;
}

}  // namespace
}  // namespace tripoint

int main(int argc, char** argv) {
  try {
    return tripoint::run(argc, argv);
  } catch (const std::exception& error) {
    tripoint::complain(error.what());
    return tripoint::kOurFault;
  }
}
