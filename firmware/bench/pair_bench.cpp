// A whole stereo pair of three LEDs, to be counted in instructions: `bench_pair ours|textbook SIZE`, under callgrind
// with collection switched on in `measured_pair` only (firmware/bench/instructions.py). Prints how many pairs were
// measured. `bench_pair spots SIZE` does the same as `ours` and prints how many spots the detector measured in all.
#include <cstdint>
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <string_view>
#include <vector>

#include "bench/sizes.h"
#include "bench/stereo_pair.h"
#include "bench/textbook.h"

namespace tripoint::bench {
namespace {

class Ours {
 public:
  explicit Ours(ImageSize size) : size_(size), measurer_(size) {}

  std::size_t measure(const PairBytes& pair) {
    const auto picture = [&](Side side) {
      return picture_of({.format = PixelFormat::kYuyv,
                         .size = size_,
                         .stride_bytes = 2 * static_cast<std::size_t>(size_.width_px),
                         .data = pair[side]});
    };
    return measurer_.measure({picture(Side::kLeft), picture(Side::kRight)});
  }

 private:
  ImageSize size_;
  PairMeasurer measurer_;
};

/// Only its detector: what it would need to triangulate is left out, in its favour.
class TextbookPair {
 public:
  explicit TextbookPair(ImageSize size) : size_(size) {}

  std::size_t measure(const PairBytes& pair) {
    std::size_t spots = 0;
    for (const Side side : kBothSides) spots += textbook_.spots(pair[side].data(), size_).size();
    return spots / 2;
  }

 private:
  ImageSize size_;
  Textbook textbook_;
};

template <typename Measurer>
[[gnu::noinline]] std::size_t measured_pair(Measurer& measurer, const PairBytes& pair) {
  return measurer.measure(pair);
}

enum class Counted : std::uint8_t { kPairs, kSpots };

template <typename Measurer>
int run(ImageSize size, Counted counted = Counted::kPairs) {
  Measurer measurer(size);
  const std::vector<PairBytes> pairs = three_leds_in_motion(size, PixelFormat::kYuyv);
  measurer.measure(pairs.front());  // memory that is taken once
  std::size_t points = 0;
  for (const PairBytes& pair : pairs) points += measured_pair(measurer, pair);
  const std::size_t spots = 2 * kLedsOfPair * (pairs.size() + 1);
  std::printf("%zu\n", counted == Counted::kSpots ? spots : pairs.size());
  if (points == kLedsOfPair * pairs.size()) return 0;
  std::fprintf(stderr, "%zu points in %zu pairs of three LEDs\n", points, pairs.size());
  return 1;
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  using namespace tripoint::bench;
  cv::setNumThreads(1);
  const std::string_view kind = argc == 3 ? argv[1] : "";
  const auto size = bench_size_from(argc == 3 ? argv[2] : "");
  if (size && kind == "ours") return run<Ours>(size->size);
  if (size && kind == "spots") return run<Ours>(size->size, Counted::kSpots);
  if (size && kind == "textbook") return run<TextbookPair>(size->size);
  std::fputs("usage: bench_pair ours|spots|textbook 640x480|320x240|720p\n", stderr);
  return 2;
}
