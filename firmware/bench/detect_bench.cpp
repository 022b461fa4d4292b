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
#include "bench/sizes.h"
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

/// Those that product goals are set for.
Figure with_goal(const Figure& figure) {
  if (figure.name == "scan_640x480_vs_textbook") return at_least(figure, 18.0);
  if (figure.name == "scan_720p_vs_textbook") return at_least(figure, 22.0);
  if (figure.name == "scan_640x480_vs_read") return at_most(figure, 1.2);
  if (figure.name == "scan_clutter_640x480_vs_read") return at_most(figure, 1.5);
  if (figure.name == "detect_640x480_vs_textbook") return at_least(figure, 12.0);
  if (figure.name == "detect_clutter_640x480_vs_textbook") return at_least(figure, 9.0);
  return figure;
}

void add_figures(std::vector<Figure>& figures, const std::string& suffix, const Times& times) {
  const auto add = [&](const std::string& name, double baseline_us, double ratio) {
    figures.push_back(with_goal(against(name, baseline_us, ratio)));
  };
  add("scan_" + suffix + "_vs_textbook", times.textbook_us, times.textbook_us / times.scan_us);
  add("scan_" + suffix + "_vs_read", times.read_us, times.scan_us / times.read_us);
  add("detect_" + suffix + "_vs_textbook", times.textbook_us, times.textbook_us / times.detect_us);
}

std::vector<Figure> scan_figures() {
  std::vector<Figure> figures;
  for (const BenchSize& each : kBenchSizes) {
    const std::string name(each.name);
    add_figures(figures, name, measured(name + " clean", scenes(clean_scene, each.size)));
    add_figures(figures, "clutter_" + name, measured(name + " dark clutter", scenes(dark_clutter, each.size)));
  }
  return figures;
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
