#include "sim/rendered_recording.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "still_world.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

SimulationSettings small_settings() {
  SimulationSettings settings = bare_settings();
  settings.rig = default_rig({.width_px = 320, .height_px = 240});
  settings.trajectory = paper_linear();
  settings.rate_hz = 2.0;
  settings.line_time = std::chrono::microseconds{40};
  return settings;
}

TEST(RenderedRecordingTest, FolderHoldsFramesTimesAndTruth) {
  const SimulatedWorld world = world_of(small_settings(), time_from_ns(12'000'000'000));
  const test::ScratchFolder scratch;
  const fs::path folder = scratch / "new";
  ASSERT_TRUE(write_rendered_recording(world, 3, folder));
  EXPECT_EQ(text_of(folder / "left" / "00000002.yuyv").size(), 320U * 240U * 2U);
  EXPECT_EQ(fs::file_size(folder / "right" / "00000000.yuyv"), 320U * 240U * 2U);
  // arrival after 239 rows of 40 us
  EXPECT_EQ(text_of(folder / "frames.csv"),
            "camera,index,exposure_mid_ns,arrival_ns\n"
            "left,0,12000000000,12009560000\nright,0,12000000000,12009560000\n"
            "left,1,12500000000,12509560000\nright,1,12500000000,12509560000\n"
            "left,2,13000000000,13009560000\nright,2,13000000000,13009560000\n");
  // the paper's line: 40, 100, 10 mm in 6 s, from phase 0 at 12 s
  EXPECT_EQ(text_of(folder / "truth.csv"),
            "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n"
            "12.000000000,-20.000000,-50.000000,395.000000,0.000000000,1.000000000,0.000000000,0.000000000\n"
            "12.500000000,-16.666667,-41.666667,395.833333,0.000000000,1.000000000,0.000000000,0.000000000\n"
            "13.000000000,-13.333333,-33.333333,396.666667,0.000000000,1.000000000,0.000000000,0.000000000\n");
  const std::string description = text_of(folder / "recording.toml");
  for (const char* line : {"format = \"tripoint-recording/1\"\n", "pixel_format = \"yuyv\"\n", "width_px = 320\n",
                           "height_px = 240\n", "line_time_us = 40"}) {
    EXPECT_NE(description.find(line), std::string::npos) << line;
  }
}

TEST(RenderedRecordingTest, FramesAreThoseOfTheRenderer) {
  SimulationSettings settings = small_settings();
  settings.format = PixelFormat::kMjpeg;
  const SimulatedWorld world = world_of(settings);
  const test::ScratchFolder folder;
  ASSERT_TRUE(write_rendered_recording(world, 2, folder.path()));
  const RenderedFrame frame = render(world, Side::kRight, std::chrono::milliseconds{500}, 1);
  const std::string written = text_of(folder / "right" / "00000001.jpg");
  EXPECT_TRUE(std::equal(written.begin(), written.end(), frame.pixels.begin(), frame.pixels.end(),
                         [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
}

TEST(RenderedRecordingTest, FolderInUseIsRefused) {
  const SimulatedWorld world = world_of(small_settings());
  const test::ScratchFolder folder;
  std::ofstream(folder / "precious.txt") << "keep";
  const Result<void> refused = write_rendered_recording(world, 1, folder.path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(text_of(folder / "precious.txt"), "keep");
}

TEST(RenderedRecordingTest, GreyIsNoFormatOfARecording) {
  SimulationSettings settings = small_settings();
  settings.format = PixelFormat::kGrey;
  const test::ScratchFolder folder;
  const Result<void> refused = write_rendered_recording(world_of(settings), 1, folder.path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
}

}  // namespace
}  // namespace tripoint
