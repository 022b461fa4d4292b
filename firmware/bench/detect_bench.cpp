// The detector against textbook OpenCV and against reading the frame once; prints a JSON list.
#include <cstdio>
#include <cstring>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

#include "bench/detect_bench_centroid.h"
#include "bench/figure.h"
#include "bench/interleaved.h"
#include "bench/painter.h"
#include "bench/textbook.h"
#include "line/detect/led_detector.h"
#include "line/detect/vectors.h"

namespace tripoint::bench {
namespace {

/// Frames in a ring larger than any cache: each is read from memory, as a camera's buffer is.
class Ring {
 public:
  Ring(const std::vector<YuyvPicture>& pictures, std::size_t bytes)
      : size_(pictures.front().size),
        frame_bytes_(pictures.front().bytes.size()),
        frames_(bytes / frame_bytes_),
        memory_(frames_ * frame_bytes_) {
    for (std::size_t i = 0; i < frames_; ++i) {
      std::memcpy(memory_.data() + i * frame_bytes_, pictures[i % pictures.size()].bytes.data(), frame_bytes_);
    }
  }

  /// Neighbouring numbers are not neighbours in memory.
  [[nodiscard]] std::span<const std::uint8_t> frame(std::size_t number) const {
    return {memory_.data() + number * 7 % frames_ * frame_bytes_, frame_bytes_};
  }
  [[nodiscard]] Picture picture(std::size_t number) const {
    return picture_of({.format = PixelFormat::kYuyv,
                       .size = size_,
                       .stride_bytes = static_cast<std::size_t>(size_.width_px) * 2,
                       .data = frame(number)});
  }
  [[nodiscard]] ImageSize size() const { return size_; }

 private:
  ImageSize size_;
  std::size_t frame_bytes_;
  std::size_t frames_;
  std::vector<std::uint8_t> memory_;
};

/// The cheapest look at every byte: four running maxima.
int read_once(std::span<const std::uint8_t> frame) {
  std::array<Bytes16, 4> largest{};
  for (std::size_t i = 0; i + 64 <= frame.size(); i += 64) {
    for (std::size_t k = 0; k < 4; ++k) largest[k] = larger(largest[k], loaded<Bytes16>(frame.data() + i + 16 * k));
  }
  return larger(larger(largest[0], largest[1]), larger(largest[2], largest[3]))[0];
}

struct Times {
  double read_us, scan_us, detect_us, textbook_us;
};

Times measured(const std::string& title, const std::vector<YuyvPicture>& pictures) {
  constexpr std::size_t kRounds = 301;
  const Ring ring(pictures, std::size_t{256} << 20U);
  const LedDetectorSettings settings;
  CoarseMap map;
  LedDetector detector(settings);
  Textbook textbook;
  std::size_t seen = 0;
  std::size_t points = 0;
  const auto medians =
      interleaved_medians_us({[&](std::size_t i) { seen += static_cast<std::size_t>(read_once(ring.frame(i))); },
                              [&](std::size_t i) {
                                map.read(ring.picture(i));
                                seen += select_cells(map, settings).cells.size();
                              },
                              [&](std::size_t i) { points += detector.detect(ring.picture(i), {}).points.size(); },
                              [&](std::size_t i) { seen += textbook.spots(ring.frame(i).data(), ring.size()).size(); }},
                             kRounds);
  std::fprintf(stderr, "%s: read %.1f us, scan %.1f, detect %.1f (%.2f spots a frame), textbook %.1f; %zu\n",
               title.c_str(), medians[0], medians[1], medians[2], static_cast<double>(points) / (kRounds + 5),
               medians[3], seen % 10);
  return {medians[0], medians[1], medians[2], medians[3]};
}

std::vector<YuyvPicture> scenes(YuyvPicture (*paint)(ImageSize, std::uint32_t), ImageSize size) {
  std::vector<YuyvPicture> pictures;
  for (std::uint32_t seed = 1; seed <= 16; ++seed) pictures.push_back(paint(size, seed));
  return pictures;
}

Figure against(const std::string& name, double baseline_us, double value) {
  return {.name = name, .value = value, .unit = "ratio", .baseline = baseline_us, .ratio = value};
}

std::vector<Figure> scan_figures() {
  const Times vga = measured("640x480 clean", scenes(clean_scene, {640, 480}));
  const Times clutter = measured("640x480 dark clutter", scenes(dark_clutter, {640, 480}));
  const Times hd = measured("1280x720 clean", scenes(clean_scene, {1280, 720}));
  return {at_least(against("scan_640x480_vs_textbook", vga.textbook_us, vga.textbook_us / vga.scan_us), 18.0),
          at_least(against("scan_720p_vs_textbook", hd.textbook_us, hd.textbook_us / hd.scan_us), 22.0),
          at_most(against("scan_640x480_vs_read", vga.read_us, vga.scan_us / vga.read_us), 1.2),
          at_most(against("scan_clutter_640x480_vs_read", clutter.read_us, clutter.scan_us / clutter.read_us), 1.5),
          at_least(against("detect_640x480_vs_textbook", vga.textbook_us, vga.textbook_us / vga.detect_us), 12.0),
          at_least(against("detect_clutter_640x480_vs_textbook", clutter.textbook_us,
                           clutter.textbook_us / clutter.detect_us),
                   9.0)};
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  cv::setNumThreads(1);
  auto figures = tripoint::bench::scan_figures();
  for (auto& figure : tripoint::bench::centroid_figures()) figures.push_back(figure);
  tripoint::bench::print(figures);
  return 0;
}
