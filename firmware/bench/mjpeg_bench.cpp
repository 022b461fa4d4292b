// A whole stereo pair of MJPEG pictures of three LEDs: ours from bytes to points in space, of whole pictures and around
// a forecast, against cv::imdecode and the textbook's detector.
//
// usage: bench_mjpeg                     times, side by side at every size; prints a JSON list
//        bench_mjpeg tracked|textbook SIZE  under callgrind with collection switched on in `measured_pair` only: prints
//        how
//                                        many pairs were measured (firmware/bench/instructions.py)
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/figure.h"
#include "bench/interleaved.h"
#include "bench/sizes.h"
#include "bench/stereo_pair.h"
#include "bench/textbook.h"
#include "bench/tracked_pair.h"
#include "capture/mjpeg_decoder.h"

namespace tripoint::bench {
namespace {

constexpr std::size_t kRounds = 300;
constexpr std::size_t kPairsUntilSettled = 130;

class Ours {
 public:
  explicit Ours(ImageSize size) : measurer_(size) {}

  std::size_t measure(const PairBytes& pair) {
    return measurer_.measure(
        {decoders_.left.decode(pair.left, {}).value(), decoders_.right.decode(pair.right, {}).value()});
  }

 private:
  PerSide<MjpegDecoder> decoders_;
  PairMeasurer measurer_;
};

/// Only its detector: what it would need to triangulate is left out, in its favour.
class TextbookPair {
 public:
  std::size_t measure(const PairBytes& pair) {
    std::size_t spots = 0;
    for (const Side side : kBothSides) {
      cv::imdecode(pair[side], cv::IMREAD_COLOR, &bgr_);
      spots += textbook_.spots_of_bgr(bgr_).size();
    }
    return spots / 2;
  }

 private:
  cv::Mat bgr_;
  Textbook textbook_;
};

/// A way that loses LEDs is not timed.
template <typename Measurer>
void demand_all_leds(Measurer& measurer, const std::vector<PairBytes>& pairs) {
  for (const PairBytes& pair : pairs) {
    if (measurer.measure(pair) < kLedsOfPair) throw std::runtime_error("bench_mjpeg: an LED was not found");
  }
}

Figure against(const std::string& name, double baseline_us, double ratio) {
  return {.name = name, .value = ratio, .unit = "ratio", .baseline = baseline_us, .ratio = ratio};
}

Figure pair_figure(const BenchSize& size, const std::vector<PairBytes>& pairs) {
  Ours ours(size.size);
  TextbookPair textbook;
  demand_all_leds(ours, pairs);
  demand_all_leds(textbook, pairs);
  std::size_t sum = 0;
  const std::vector<double> us =
      interleaved_medians_us({
                                 [&](std::size_t i) { sum += ours.measure(pairs[i % pairs.size()]); },
                                 [&](std::size_t i) { sum += textbook.measure(pairs[i % pairs.size()]); },
                             },
                             kRounds);
  const std::string name = sized_name("mjpeg_pair", size, "vs_textbook");
  std::fprintf(stderr, "%s: %.0f us, textbook %.0f us (%zu points)\n", name.c_str(), us[0], us[1], sum);
  return against(name, us[1], us[1] / us[0]);
}

/// There and back, so that the LEDs never jump.
const PairBytes& pair_at(const std::vector<PairBytes>& pairs, std::size_t i) {
  const std::size_t turn = pairs.size() - 1;
  const std::size_t k = i % (2 * turn);
  return pairs[k <= turn ? k : 2 * turn - k];
}

/// Until the forecast has settled; then one picture in five is seen whole, and every LED is found in each pair.
void demand_tracking(TrackedPair& tracked, const std::vector<PairBytes>& pairs) {
  constexpr std::size_t kSettled = 10;
  std::size_t whole = 0;
  for (std::size_t i = 0; i < kPairsUntilSettled; ++i) {
    const std::size_t found = tracked.measure(pair_at(pairs, i));
    if (i >= kSettled) whole += tracked.whole_pictures();
    if (found != kLedsOfPair) throw std::runtime_error("bench_mjpeg: an LED was not found around its forecast");
  }
  if (whole != 2 * (kPairsUntilSettled - kSettled) / kFramesPerWhole) {
    throw std::runtime_error("bench_mjpeg: not every fifth picture was seen whole");
  }
}

/// Medians of five pairs in a row, of which ours sees one whole.
Figure tracking_figure(const BenchSize& size, const std::vector<PairBytes>& pairs) {
  TrackedPair ours(size.size);
  TextbookPair textbook;
  demand_tracking(ours, pairs);
  std::size_t next = kPairsUntilSettled;
  std::size_t sum = 0;
  const auto five = [&](auto& measurer, std::size_t first) {
    for (std::size_t k = 0; k < kFramesPerWhole; ++k) sum += measurer.measure(pair_at(pairs, first + k));
  };
  const std::vector<double> us = interleaved_medians_us({
                                                            [&](std::size_t) {
                                                              five(ours, next);
                                                              next += kFramesPerWhole;
                                                            },
                                                            [&](std::size_t i) { five(textbook, kFramesPerWhole * i); },
                                                        },
                                                        kRounds);
  const std::string name = sized_name("mjpeg_pair_tracking", size, "vs_textbook");
  std::fprintf(stderr, "%s: %.0f us, textbook %.0f us (%zu points)\n", name.c_str(), us[0] / kFramesPerWhole,
               us[1] / kFramesPerWhole, sum);
  return against(name, us[1] / kFramesPerWhole, us[1] / us[0]);
}

int time_all_sizes() {
  std::vector<Figure> figures;
  for (const BenchSize& size : kBenchSizes) {
    const auto pairs = three_leds_in_motion(size.size, PixelFormat::kMjpeg);
    const Figure whole = pair_figure(size, pairs);
    const Figure tracked = tracking_figure(size, pairs);
    const bool has_goals = size.name == kBenchSizes.front().name;
    figures.push_back(has_goals ? at_least(whole, 5.0) : whole);
    figures.push_back(has_goals ? at_least(tracked, 12.0) : tracked);
  }
  print(figures);
  return 0;
}

template <typename Measurer>
[[gnu::noinline]] std::size_t measured_pair(Measurer& measurer, const PairBytes& pair) {
  return measurer.measure(pair);
}

/// Of every five pairs one is seen whole.
template <typename Measurer>
int count(Measurer measurer, const std::vector<PairBytes>& pairs) {
  constexpr std::size_t kCounted = 6 * kFramesPerWhole;
  std::size_t points = 0;
  for (std::size_t i = 0; i < kCounted; ++i) points += measured_pair(measurer, pair_at(pairs, kPairsUntilSettled + i));
  std::printf("%zu\n", kCounted);
  return points == kLedsOfPair * kCounted ? 0 : 1;
}

int count_tracked(const BenchSize& size) {
  const auto pairs = three_leds_in_motion(size.size, PixelFormat::kMjpeg);
  TrackedPair tracked(size.size);
  demand_tracking(tracked, pairs);
  return count(std::move(tracked), pairs);
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  using namespace tripoint::bench;
  cv::setNumThreads(1);
  if (argc == 1) return time_all_sizes();
  const std::string_view kind = argv[1];
  const auto size = bench_size_from(argc == 3 ? argv[2] : "");
  if (size && kind == "tracked") return count_tracked(*size);
  if (size && kind == "textbook") {
    return count(TextbookPair{}, three_leds_in_motion(size->size, tripoint::PixelFormat::kMjpeg));
  }
  std::fputs("usage: bench_mjpeg [tracked|textbook 640x480|320x240|720p]\n", stderr);
  return 2;
}
