// A whole stereo pair of MJPEG pictures of three LEDs: ours from bytes to points in space, against cv::imdecode and the
// textbook's detector, side by side; prints a JSON list.
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "bench/figure.h"
#include "bench/interleaved.h"
#include "bench/stereo_pair.h"
#include "bench/textbook.h"
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

}  // namespace
}  // namespace tripoint::bench

int main() {
  cv::setNumThreads(1);
  tripoint::bench::print(
      {tripoint::bench::pair_figure(tripoint::bench::three_leds_in_motion(tripoint::PixelFormat::kMjpeg))});
}
