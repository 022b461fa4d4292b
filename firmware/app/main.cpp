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
#include "app/replay_command.h"
#include "app/run_command.h"
#include "app/version.h"

namespace tripoint {
namespace {

bool processor_is_supported() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  return __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("popcnt") != 0;
#else
  return true;
#endif
}

struct Arguments {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::vector<std::filesystem::path> images;
  std::string detector = "led";
  bool json = false;
  ReplayOptions replay;
};

void describe(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  CLI::App* run = app.add_subcommand("run", "measure and serve until SIGINT or SIGTERM");
  run->add_option("--config", arguments.config, "configuration file")->required();
  run->add_option("--set", arguments.overrides, "table.key=value, overrides the file; may be repeated");

  CLI::App* check = app.add_subcommand("check-config", "say whether `run` would start with a file");
  check->add_option("file", arguments.config, "configuration file")->required();
  check->add_option("--set", arguments.overrides, "table.key=value, overrides the file; may be repeated");

  app.add_subcommand("cameras", "list the cameras of this machine by USB port and serial")
      ->add_flag("--json", arguments.json, "one JSON list");

  CLI::App* detect = app.add_subcommand("detect", "print what the detector finds in pictures, one JSON line each");
  detect->add_option("images", arguments.images, "JPEG or PNG files")->required();
  detect->add_option("--detector", arguments.detector, "what to look for")->check(CLI::IsMember({"led"}));
  detect->add_option("--config", arguments.config, "configuration file: its [detector]");
  detect->add_flag("--json", arguments.json, "JSON lines (the only format)");

  ReplayOptions& replay = arguments.replay;
  CLI::App* replaying = app.add_subcommand("replay", "measure a recording, one JSON line for each verdict");
  replaying->add_option("folder", replay.folder, "recording folder")->required();
  replaying->add_option("--calibration", replay.calibration, "calibration file")->required();
  replaying->add_option("--target", replay.target, "target file; default: one LED");
  replaying->add_option("--config", replay.config, "configuration file: limits, volume, timing");
  replaying->add_option("--frame", replay.frame, "frame of the output")
      ->check(CLI::IsMember({"reference", "left_camera"}));
  replaying->add_flag("--json", arguments.json, "JSON lines (the only format)");

  app.add_subcommand("version", "print the version");
}

int dispatch(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("run")) return run_command(arguments.config, arguments.overrides);
  if (app.got_subcommand("check-config")) return check_config_command(arguments.config, arguments.overrides);
  if (app.got_subcommand("cameras")) return cameras_command(arguments.json);
  if (app.got_subcommand("detect")) return detect_command(arguments.images, arguments.config);
  if (app.got_subcommand("replay")) return replay_command(arguments.replay);
  fmt::print("tripointd {}\n", version_text());
  return number(ExitCode::kWell);
}

int run_program(int argc, char** argv) {
  CLI::App app("Tripoint: finds red LEDs with two cameras and tells a PLC where they are. Not a safety function.",
               "tripointd");
  Arguments arguments;
  describe(app, arguments);
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
  if (!tripoint::processor_is_supported()) {
    std::fputs("tripointd: this processor is older than x86-64-v2 (needs SSE4.2 and POPCNT)\n", stderr);
    return tripoint::number(tripoint::ExitCode::kUsage);
  }
  try {
    return tripoint::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tripointd: our fault: %s\n", error.what());
    return tripoint::number(tripoint::ExitCode::kOurFault);
  }
}
