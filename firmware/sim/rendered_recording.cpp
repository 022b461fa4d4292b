#include "sim/rendered_recording.h"

#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "sim/frame_schedule.h"
#include "sim/renderer.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannot_write(const fs::path& path, const std::string& why) {
  return failure(ErrorCode::kCannotWrite, path.string() + ": " + why);
}

Result<void> write_whole(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) return cannot_write(path, "cannot be written");
  return {};
}

Result<void> make_folders(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_empty(folder, error)) {
    return cannot_write(folder, "is not an empty folder; name a new one");
  }
  for (const Side side : kBothSides) fs::create_directories(folder / name(side), error);
  if (error) return cannot_write(folder, error.message());
  return {};
}

std::string recording_toml(const SimulationSettings& settings, std::string_view extension) {
  const ImageSize size = settings.rig.cameras.left.size;
  return fmt::format(
      "format = \"tripoint-recording/1\"\npixel_format = \"{}\"\nwidth_px = {}\nheight_px = {}\n"
      "line_time_us = {}\nutc_offset_ns = 0\n",
      extension, size.width_px, size.height_px, seconds(settings.line_time) * 1e6);
}

std::string truth_row(const Trajectory& trajectory, TimePoint exposed) {
  const Isometry3 pose = target_pose_at(trajectory, exposed.time_since_epoch());
  const Vec3 at_mm = pose.translation();
  const Eigen::Quaterniond rotation(pose.linear());
  return fmt::format("{:.9f},{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f},{:.9f}\n", seconds(exposed.time_since_epoch()),
                     at_mm.x(), at_mm.y(), at_mm.z(), rotation.w(), rotation.x(), rotation.y(), rotation.z());
}

}  // namespace

Result<void> write_rendered_recording(const SimulatedWorld& world, int frames, const fs::path& folder) {
  const SimulationSettings& settings = world.settings();
  if (settings.format == PixelFormat::kGrey) {
    return failure(ErrorCode::kOutOfRange, "a recording is yuyv, jpg or png, not grey");
  }
  const std::string_view extension = settings.format == PixelFormat::kMjpeg ? "jpg" : "yuyv";
  if (const Result<void> made = make_folders(folder); !made) return made;
  const PerSide<FrameSchedule> schedules{{world, Side::kLeft}, {world, Side::kRight}};
  PerSide<FrameRenderer> renderers{{world, Side::kLeft}, {world, Side::kRight}};
  std::string rows = "camera,index,exposure_mid_ns,arrival_ns\n";
  std::string truth = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
  TimePoint last_truth = TimePoint::min();
  for (int i = 0; i < frames; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    for (const Side side : kBothSides) {
      const FrameSchedule& schedule = schedules[side];
      const TimePoint exposed = schedule.exposed(number);
      const RenderedFrame& frame = renderers[side].render(exposed.time_since_epoch(), number);
      const std::string_view bytes(reinterpret_cast<const char*>(frame.pixels.data()), frame.pixels.size());
      const fs::path path = folder / name(side) / fmt::format("{:08d}.{}", i, extension);
      if (const Result<void> written = write_whole(path, bytes); !written) return written;
      rows += fmt::format("{},{},{},{}\n", name(side), i, ns_from_time(schedule.stamp(number)),
                          ns_from_time(schedule.ready(number)));
      if (exposed > last_truth) truth += truth_row(settings.trajectory, exposed);
      last_truth = std::max(last_truth, exposed);
    }
  }
  return write_whole(folder / "truth.csv", truth)
      .and_then([&] { return write_whole(folder / "frames.csv", rows); })
      .and_then([&] { return write_whole(folder / "recording.toml", recording_toml(settings, extension)); });
}

}  // namespace tripoint
