#include "app/snapshot_command.h"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "app/board_levels.h"
#include "app/camera_pair.h"
#include "app/camera_supply.h"
#include "app/exit_code.h"
#include "app/exposing.h"
#include "devices/system_clock.h"
#include "document/file.h"
#include "explain/png_encoder.h"
#include "explain/rgb_image.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// One camera's picture.
struct Shot {
  RgbImage image;
  BoardSight board;
  Duration exposed_since_1970{0};
};

struct Snapshot {
  ExposureSetting setting;
  PerSide<Shot> shots;
};

RgbImage luma_of(Picture picture) {
  picture.u = {};
  picture.v = {};
  return rgb_of(picture);
}

Result<ExposureSetting> calibrating_setting(const Config& config, const fs::path& file) {
  if (config.cameras.source == CameraSource::kRecording) {
    return failure(ErrorCode::kMismatch, "cameras.source is \"recording\": its pictures are in its folder already");
  }
  if (config.cameras.calibrating) return *config.cameras.calibrating;
  return failure(ErrorCode::kMissingKey,
                 fmt::format("{0}: [cameras.calibrating] is missing: `tripointd expose --config {0} --for calibrating "
                             "--write` finds it",
                             file.string()));
}

Result<void> made(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return {};
  return failure(ErrorCode::kCannotWrite, fmt::format("{}: {}", folder.string(), error.message()));
}

Result<Snapshot> taken(const Config& config, const ExposureSetting& setting) {
  const SystemClock clock;
  const Result<CameraPair> cameras = CameraPair::open(
      config, [&](const Config& wanted) { return cameras_before_board(wanted, clock); }, setting);
  if (!cameras) return tl::make_unexpected(cameras.error());
  Snapshot snapshot{.setting = cameras->setting(), .shots = {}};
  return cameras
      ->shoot([&](Side side, const Picture& picture, TimePoint exposed) {
        snapshot.shots[side] = {.image = luma_of(picture),
                                .board = board_sight(picture),
                                .exposed_since_1970 = exposed.time_since_epoch() + clock.utc_offset()};
      })
      .map([&] { return std::move(snapshot); });
}

/// "20261127T152701.123Z"
std::string stamp(Duration since_1970) {
  const std::chrono::sys_time<std::chrono::milliseconds> time(
      std::chrono::duration_cast<std::chrono::milliseconds>(since_1970));
  const auto second = std::chrono::floor<std::chrono::seconds>(time);
  return fmt::format("{:%Y%m%dT%H%M%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                     (time - second).count());
}

/// Both, or none.
///
/// @return where they are; kCannotWrite
Result<PerSide<fs::path>> written(const Snapshot& snapshot, const fs::path& folder) {
  PerSide<fs::path> files;
  for (const Side side : kBothSides) {
    files[side] = folder / fmt::format("{}-{}.png", name(side), stamp(snapshot.shots.left.exposed_since_1970));
    const Result<void> done = png_of(snapshot.shots[side].image).and_then([&](const std::string& png) {
      return write_file_whole(files[side], png);
    });
    if (done) continue;
    std::error_code ignored;  // there is none to be removed when the left one failed
    fs::remove(files.left, ignored);
    return tl::make_unexpected(done.error());
  }
  return files;
}

ordered_json json_of(const Shot& shot, const fs::path& file) {
  ordered_json line = {
      {"file", file.string()}, {"exposed_ns", shot.exposed_since_1970.count()}, {"white", nullptr}, {"black", nullptr}};
  if (shot.board.levels) line["white"] = rounded(shot.board.levels->white);
  if (shot.board.levels) line["black"] = rounded(shot.board.levels->black);
  return line;
}

std::string words(const Shot& shot) {
  if (!shot.board.levels) return "no board is seen";
  return fmt::format("white {:.0f} %, black {:.0f} % of clip", 100.0 * shot.board.levels->white,
                     100.0 * shot.board.levels->black);
}

void tell(const Snapshot& snapshot, const PerSide<fs::path>& files, bool json) {
  if (json) {
    const ordered_json line = {{"exposure_us", snapshot.setting.exposure.count()},
                               {"gain", snapshot.setting.gain},
                               {"left", json_of(snapshot.shots.left, files.left)},
                               {"right", json_of(snapshot.shots.right, files.right)}};
    fmt::print("{}\n", line.dump());
    return;
  }
  for (const Side side : kBothSides) fmt::print("{}: {}\n", files[side].string(), words(snapshot.shots[side]));
}

}  // namespace

int snapshot_command(const SnapshotOptions& options) {
  const Result<Config> config = load_config(options.config, options.overrides);
  if (!config) return report(config.error());
  const Result<ExposureSetting> setting = calibrating_setting(*config, options.config);
  if (!setting) return report(setting.error());
  if (const Result<void> folder = made(options.out); !folder) return report(folder.error());
  const Result<Snapshot> snapshot = taken(*config, *setting);
  if (!snapshot) return report(snapshot.error());
  const Result<PerSide<fs::path>> files = written(*snapshot, options.out);
  if (!files) return report(files.error());
  tell(*snapshot, *files, options.json);
  return number(ExitCode::kWell);
}

}  // namespace tripoint
