// The sizes of pictures that the benchmarks measure, and how the figures' names call them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "values/pixel.h"

namespace tripoint::bench {

struct BenchSize {
  std::string_view name;
  ImageSize size;
};
/// 640x480 first: the goals are its.
inline constexpr std::array<BenchSize, 3> kBenchSizes{
    {{"640x480", {640, 480}}, {"320x240", {320, 240}}, {"720p", {1280, 720}}}};

/// Nothing for a name that is none of a size.
inline std::optional<BenchSize> bench_size_from(std::string_view name) {
  for (const BenchSize& each : kBenchSizes) {
    if (each.name == name) return each;
  }
  return std::nullopt;
}

/// Of a figure that is called after no size at 640x480: "mjpeg_pair" and "vs_textbook" give "mjpeg_pair_vs_textbook"
/// and "mjpeg_pair_720p_vs_textbook".
inline std::string sized_name(std::string_view what, const BenchSize& size, std::string_view against) {
  const std::string middle = size.name == kBenchSizes.front().name ? "_" : "_" + std::string(size.name) + "_";
  return std::string(what) + middle + std::string(against);
}

}  // namespace tripoint::bench
