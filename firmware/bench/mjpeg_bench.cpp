// A whole stereo pair of MJPEG pictures of three LEDs: ours from bytes to points in space, of whole pictures and around
// a forecast, against cv::imdecode and the textbook's detector, side by side; prints a JSON list.
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "bench/figure.h"
#include "bench/interleaved.h"
#include "bench/stereo_pair.h"
#include "bench/textbook.h"
#include "bench/tracked_pair.h"
#include "capture/mjpeg_decoder.h"

namespace tripoint::bench {
namespace {

constexpr std::size_t kRounds = 300;

class Ours {
 public:
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

Figure pair_figure(const std::vector<PairBytes>& pairs) {
  Ours ours;
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
  std::fprintf(stderr, "MJPEG pair of 640x480: %.0f us, textbook %.0f us (%zu points)\n", us[0], us[1], sum);
  return at_least({.name = "mjpeg_pair_vs_textbook",
                   .value = us[1] / us[0],
                   .unit = "ratio",
                   .baseline = us[1],
                   .ratio = us[1] / us[0]},
                  5.0);
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
  constexpr std::size_t kPairs = 130;
  std::size_t whole = 0;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const std::size_t found = tracked.measure(pair_at(pairs, i));
    if (i >= kSettled) whole += tracked.whole_pictures();
    if (found != kLedsOfPair) throw std::runtime_error("bench_mjpeg: an LED was not found around its forecast");
  }
  if (whole != 2 * (kPairs - kSettled) / kFramesPerWhole) {
    throw std::runtime_error("bench_mjpeg: not every fifth picture was seen whole");
  }
}

/// Medians of five pairs in a row, of which ours sees one whole.
Figure tracking_figure(const std::vector<PairBytes>& pairs) {
  TrackedPair ours;
  TextbookPair textbook;
  demand_tracking(ours, pairs);
  std::size_t next = 130;
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
  std::fprintf(stderr, "tracked MJPEG pair of 640x480: %.0f us, textbook %.0f us (%zu points)\n",
               us[0] / kFramesPerWhole, us[1] / kFramesPerWhole, sum);
  return at_least({.name = "mjpeg_pair_tracking_vs_textbook",
                   .value = us[1] / us[0],
                   .unit = "ratio",
                   .baseline = us[1] / kFramesPerWhole,
                   .ratio = us[1] / us[0]},
                  12.0);
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  cv::setNumThreads(1);
  const auto pairs = tripoint::bench::three_leds_in_motion(tripoint::PixelFormat::kMjpeg);
  tripoint::bench::print({tripoint::bench::pair_figure(pairs), tripoint::bench::tracking_figure(pairs)});
}
