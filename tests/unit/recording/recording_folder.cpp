#include "recording_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace tripoint::test {

RecordingFolder::RecordingFolder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  path_ =
      std::filesystem::path(testing::TempDir()) / fmt::format("recording_{}_{}", test->test_suite_name(), test->name());
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_ / "left");
  std::filesystem::create_directories(path_ / "right");
}

void RecordingFolder::write(const std::filesystem::path& name, std::string_view text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
}

void RecordingFolder::describe(std::string_view pixel_format) const {
  write("recording.toml", fmt::format("format = \"tripoint-recording/1\"\npixel_format = \"{}\"\nwidth_px = {}\n"
                                      "height_px = {}\nline_time_us = 30.5\n",
                                      pixel_format, kWidth_px, kHeight_px));
}

void RecordingFolder::picture(std::string_view side, int index, char value) const {
  write(fmt::format("{}/{:08d}.yuyv", side, index), std::string(kYuyv_bytes, value));
}

}  // namespace tripoint::test
