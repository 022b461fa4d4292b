// A whole stereo pair of three LEDs, to be counted in instructions: `bench_pair ours|textbook`, under callgrind with
// collection switched on in `measured_pair` only (firmware/bench/instructions.py). Prints how many pairs were measured.
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <string_view>
#include <vector>

#include "bench/stereo_pair.h"
#include "bench/textbook.h"

namespace tripoint::bench {
namespace {

constexpr ImageSize kSize{640, 480};

class Ours {
 public:
  std::size_t measure(const PairBytes& pair) {
    const auto picture = [&](Side side) {
      return picture_of({.format = PixelFormat::kYuyv,
                         .size = kSize,
                         .stride_bytes = 2 * static_cast<std::size_t>(kSize.width_px),
                         .data = pair[side]});
    };
    return measurer_.measure({picture(Side::kLeft), picture(Side::kRight)});
  }

 private:
  PairMeasurer measurer_;
};

/// Only its detector: what it would need to triangulate is left out, in its favour.
class TextbookPair {
 public:
  std::size_t measure(const PairBytes& pair) {
    std::size_t spots = 0;
    for (const Side side : kBothSides) spots += textbook_.spots(pair[side].data(), kSize).size();
    return spots / 2;
  }

 private:
  Textbook textbook_;
};

template <typename Measurer>
[[gnu::noinline]] std::size_t measured_pair(Measurer& measurer, const PairBytes& pair) {
  return measurer.measure(pair);
}

template <typename Measurer>
int run(Measurer measurer) {
  const std::vector<PairBytes> pairs = three_leds_in_motion(PixelFormat::kYuyv);
  measurer.measure(pairs.front());  // memory that is taken once
  std::size_t points = 0;
  for (const PairBytes& pair : pairs) points += measured_pair(measurer, pair);
  std::printf("%zu\n", pairs.size());
  if (points == kLedsOfPair * pairs.size()) return 0;
  std::fprintf(stderr, "%zu points in %zu pairs of three LEDs\n", points, pairs.size());
  return 1;
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  using namespace tripoint::bench;
  cv::setNumThreads(1);
  const bool textbook = argc == 2 && std::string_view(argv[1]) == "textbook";
  return textbook ? run(TextbookPair{}) : run(Ours{});
}
