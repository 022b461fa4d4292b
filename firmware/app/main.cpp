// tripointd: two cameras in, a position with its uncertainty out. Start reading at composition.cpp.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cameras_command.h"
#include "app/detect_command.h"
#include "app/exit_code.h"
#include "app/expose_command.h"
#include "app/replay_command.h"
#include "app/run_command.h"
#include "app/snapshot_command.h"
#include "app/version.h"

namespace tripoint {
namespace {

struct Arguments {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  DetectOptions detect;
  bool json = false;
  ReplayOptions replay;
  ExposeOptions expose;
  std::string purpose = "measuring";
  std::filesystem::path out;
};

constexpr const char* kExitCodes =
    "Exit codes: 0 well; 1 no exposure suits (expose); 2 usage, configuration, an unreadable file, a port in use or\n"
    "an output that cannot be written; 3 a device is missing (never from run, which waits) or in use; 70 our fault.\n"
    "Messages go to stderr.\n\n"
    "Example: tripointd run --config unit.toml";

void add_configuration(CLI::App& command, Arguments& arguments, const std::string& name) {
  command.add_option(name, arguments.config, "configuration file (docs/reference/configuration.md)")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--set", arguments.overrides, "overrides values of the file, as modbus.port=1503; may be repeated")
      ->type_name("KEY=VALUE");
}

void describe_running(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand("run", "Measures and serves Modbus until SIGINT or SIGTERM.");
  add_configuration(*run, arguments, "--config");
  run->footer(
      "A missing camera is waited for. The log goes to stderr.\n\n"
      "Example: tripointd run --config unit.toml --set modbus.port=502");

  CLI::App* check = app.add_subcommand("check-config", "Says whether `run` would start with a file.");
  add_configuration(*check, arguments, "file");
  check->get_option("file")->description("configuration file, written before --set (docs/reference/configuration.md)");
  check->footer(
      "Reads the files that it names as well, opens no camera and no port. Prints the setup (register 146).\n\n"
      "Example: tripointd check-config unit.toml --set output.frame=left_camera");

  CLI::App* cameras = app.add_subcommand("cameras", "Lists the cameras of this machine by USB port and serial number.");
  cameras->add_flag("--json", arguments.json, "one JSON list instead of a table");
  cameras->footer(
      "The configuration binds left and right by port or serial. Exit code 3: there is none.\n\n"
      "Example: tripointd cameras --json");
}

void describe_exposing(CLI::App& app, Arguments& arguments) {
  CLI::App* expose = app.add_subcommand("expose", "Finds exposure and gain, and checks them in a picture.");
  add_configuration(*expose, arguments, "--config");
  expose
      ->add_option("--for", arguments.purpose,
                   "measuring: of the LEDs, for [cameras]; calibrating: of a board, for [cameras.calibrating]")
      ->type_name("PURPOSE")
      ->check(CLI::IsMember({"measuring", "calibrating"}))
      ->capture_default_str();
  expose->add_flag("--write", arguments.expose.write,
                   "writes exposure_us and gain into the file; else prints the lines");
  expose
      ->add_option("--gain", arguments.expose.gain,
                   "keeps this gain: a higher one allows a shorter exposure; default: the lowest that is enough")
      ->type_name("GAIN")
      ->check(CLI::Range(0, 65535));
  expose->add_flag("--json", arguments.json, "JSON lines: each look, then what was chosen");
  expose->footer(
      "Someone holds the target at the near, then at the far end of the working volume, or a board before both\n"
      "cameras, and presses Enter. Simulated cameras see it held there. Stop the unit first: a camera that is in use "
      "ends with exit code 3.\n\n"
      "Example: tripointd expose --config unit.toml --for calibrating --write");
}

void describe_snapshot(CLI::App& app, Arguments& arguments) {
  CLI::App* snapshot = app.add_subcommand(
      "snapshot", "Takes one picture of each camera, exposed for calibrating as [cameras.calibrating] says.");
  add_configuration(*snapshot, arguments, "--config");
  snapshot->add_option("--out", arguments.out, "where left-STAMP.png and right-STAMP.png go; made when it is absent")
      ->type_name("FOLDER")
      ->required();
  snapshot->add_flag("--json", arguments.json, "one JSON line");
  snapshot->footer(
      "The right picture follows the left one within two frames: keep the board still. Simulated cameras see one.\n"
      "Stop the unit first: a camera that is in use ends with exit code 3.\n\n"
      "Example: tripointd snapshot --config unit.toml --out board");
}

void describe_pictures(CLI::App& app, Arguments& arguments) {
  DetectOptions& options = arguments.detect;
  CLI::App* detect = app.add_subcommand(
      "detect", "Prints the red LEDs, spheres or AprilTags that the detector finds in pictures, one JSON line each.");
  detect->add_option("images", options.images, "JPEG or PNG files")->type_name("IMAGE")->required();
  detect
      ->add_option("--detector", options.detector,
                   "what to look for: led, sphere or apriltag; default: as configured, or led")
      ->type_name("NAME")
      ->check(CLI::IsMember({"led", "sphere", "apriltag"}));
  detect->add_option("--family", options.family, "family of the AprilTags")->type_name("NAME")->capture_default_str();
  detect->add_option("--config", options.config, "configuration file, for its [detector]; default: all defaults")
      ->type_name("FILE");
  detect
      ->add_option("--explain", options.explain,
                   "writes FOLDER/NAME.explain.png for each image: everything looked at, kept or dropped, and why")
      ->type_name("FOLDER");
  detect->add_flag("--json", arguments.json, "JSON lines: the only format, also without this");
  detect->footer(
      "u_px, v_px: pixel centres are integers; covariance in px^2; peak is luma, 0 to 255.\n\n"
      "Example: tripointd detect left.png right.png --explain why --json");
}

void describe_replay(CLI::App& app, Arguments& arguments) {
  ReplayOptions& replay = arguments.replay;
  CLI::App* replaying = app.add_subcommand("replay", "Measures a recording, one JSON line for each verdict.");
  replaying->add_option("folder", replay.folder, "recording folder")->type_name("FOLDER")->required();
  replaying->add_option("--calibration", replay.calibration, "calibration file")->type_name("FILE")->required();
  replaying->add_option("--target", replay.target, "target file; default: one LED")->type_name("FILE");
  replaying
      ->add_option("--config", replay.config,
                   "configuration file: limits, volume, timing; default: no volume, 10 ms between the cameras' clocks")
      ->type_name("FILE");
  replaying->add_option("--frame", replay.frame, "frame of the output")
      ->type_name("NAME")
      ->check(CLI::IsMember({"reference", "left_camera"}))
      ->capture_default_str();
  replaying->add_flag("--json", arguments.json, "JSON lines: the only format, also without this");
  replaying->footer(
      "Positions in mm, covariances in mm^2, times in ns; null is unknown.\n\n"
      "Example: tripointd replay recording --calibration calibration.toml --config unit.toml --json");
}

void describe(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  app.footer(kExitCodes);
  describe_running(app, arguments);
  describe_exposing(app, arguments);
  describe_snapshot(app, arguments);
  describe_pictures(app, arguments);
  describe_replay(app, arguments);
  app.add_subcommand("version", "Prints the version.")->footer("Example: tripointd version");
}

int dispatch(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("run")) return run_command(arguments.config, arguments.overrides);
  if (app.got_subcommand("check-config")) return check_config_command(arguments.config, arguments.overrides);
  if (app.got_subcommand("cameras")) return cameras_command(arguments.json);
  if (app.got_subcommand("expose")) {
    ExposeOptions expose = arguments.expose;
    expose.config = arguments.config;
    expose.overrides = arguments.overrides;
    expose.purpose = arguments.purpose == "calibrating" ? ExposeFor::kCalibrating : ExposeFor::kMeasuring;
    expose.json = arguments.json;
    return expose_command(expose);
  }
  if (app.got_subcommand("snapshot")) {
    return snapshot_command({arguments.config, arguments.overrides, arguments.out, arguments.json});
  }
  if (app.got_subcommand("detect")) return detect_command(arguments.detect);
  if (app.got_subcommand("replay")) return replay_command(arguments.replay);
  fmt::print("tripointd {}\n", version_text());
  return number(ExitCode::kWell);
}

/// What is wrong with the command line, in one line. A word in the place of the subcommand is named, with all there
/// are: CLI11 itself only says that a subcommand is required.
std::string refusal(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> chosen = app->get_subcommands();
  const std::vector<std::string> unknown = app->remaining();
  const bool option_first = !unknown.empty() && unknown.front().starts_with('-');
  if (!chosen.empty()) {
    const std::string& command = chosen.front()->get_name();
    if (option_first) {
      return fmt::format("tripointd: {0} stands before the subcommand: write `tripointd {1} {0}`\n", unknown.front(),
                         command);
    }
    return fmt::format("tripointd {0}: {1}; `tripointd {0} --help` lists what it takes\n", command, error.what());
  }
  std::string known;
  for (const CLI::App* command : app->get_subcommands(nullptr)) {
    known += fmt::format("{}{}", known.empty() ? "" : ", ", command->get_name());
  }
  const std::string what = unknown.empty() || option_first ? "a subcommand is missing"
                                                           : fmt::format("'{}' is no subcommand", unknown.front());
  return fmt::format("tripointd: {}: write one of {}; `tripointd --help` explains them\n", what, known);
}

int run_program(int argc, char** argv) {
  CLI::App app("Tripoint: finds red LEDs with two cameras and tells a PLC where they are. Not a safety function.",
               "tripointd");
  Arguments arguments;
  describe(app, arguments);
  app.failure_message(refusal);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? number(ExitCode::kWell) : number(ExitCode::kUsage);
  }
  return dispatch(app, arguments);
}

}  // namespace
}  // namespace tripoint

int main(int argc, char** argv) {
  try {
    return tripoint::code_with_output_written(tripoint::run_program(argc, argv));
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return tripoint::code_with_output_written(0);
    std::fprintf(stderr, "tripointd: our fault: %s\n", error.what());
    return tripoint::number(tripoint::ExitCode::kOurFault);
  }
}
