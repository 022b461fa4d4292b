#include "recording_folder.h"

#include <fmt/format.h>

#include <fstream>

namespace tripoint::test {

RecordingFolder::RecordingFolder() {
  std::filesystem::create_directory(folder_ / "left");
  std::filesystem::create_directory(folder_ / "right");
}

void RecordingFolder::write(const std::filesystem::path& name, std::string_view text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
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
