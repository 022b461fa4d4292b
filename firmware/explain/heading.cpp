#include "explain/heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/look.h"

namespace tripoint {
namespace {

constexpr double kLineHeight_px = 24.0;
constexpr double kTitleLine_px = 34.0;
constexpr double kBlank_px = 18.0;

/// Lines that are no wider than `width_px`, broken at blanks.
std::vector<std::string> lines_of(const std::string& text, const Type& type, double width_px) {
  std::vector<std::string> lines(1);
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width_px(longer, type) <= width_px) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
    start = end + 1;
  }
  return lines;
}

/// Writes from left to right and from line to line.
class Page {
 public:
  Page(int width_px, int height_px) : canvas_({width_px, height_px}, kGround) {}

  void title(const Heading& heading) {
    const Type small{kFaint, kMedium_px};
    const Type large{kText, kLarge_px, true};
    const double size_width_px = text_width_px(heading.size, small);
    const double room_px = right_px() - kMargin_px - size_width_px - kBlank_px;
    canvas_.write(fitting_text(heading.title, large, room_px), {kMargin_px, y_px_}, large);
    canvas_.write(heading.size, {right_px() - size_width_px, y_px_}, small);
    y_px_ += kTitleLine_px;
  }

  void part(const std::string& text, const Type& type) {
    canvas_.write(text, {x_px_, y_px_}, type);
    x_px_ += text_width_px(text, type) + kBlank_px;
  }

  void rest(const std::string& text, const Type& type) {
    for (const std::string& line : lines_of(text, type, right_px() - x_px_)) {
      canvas_.write(line, {x_px_, y_px_}, type);
      y_px_ += kLineHeight_px;
    }
    x_px_ = kMargin_px;
  }

  void meaning(const Meaning& meaning) {
    constexpr double kReach_px = 10.0;
    meaning.draw(canvas_, CanvasPoint{x_px_ + kReach_px, y_px_ - 0.5 * kSmall_px});
    x_px_ += 2.0 * kReach_px + 0.5 * kBlank_px;
    part(meaning.text, {kText, kSmall_px});
  }

  [[nodiscard]] RgbImage image() const {
    RgbImage image = canvas_.image();
    const auto used = static_cast<int>(std::lround(y_px_));
    image.size.height_px = std::min(used, image.size.height_px);
    image.values.resize(image.index(0, image.size.height_px));
    return image;
  }

 private:
  [[nodiscard]] double right_px() const { return canvas_.image().size.width_px - static_cast<double>(kMargin_px); }

  Canvas canvas_;
  double x_px_ = kMargin_px;
  double y_px_ = kMargin_px + kLarge_px;
};

}  // namespace

RgbImage heading_of(const Heading& heading, int width_px) {
  constexpr int kMostHeight_px = 400;  // cut to what is used
  Page page(width_px, kMostHeight_px);
  page.title(heading);
  page.part(fmt::format("{} kept", heading.kept), {kKeptColour, kMedium_px, true});
  page.part(fmt::format("{} dropped", heading.dropped), {kDroppedColour, kMedium_px, true});
  page.rest(heading.causes, {kText, kMedium_px});
  for (const std::string& note : heading.notes) page.rest(note, {kFaint, kSmall_px});
  for (const Meaning& meaning : heading.legend) page.meaning(meaning);
  page.rest("", {kText, kSmall_px});
  return page.image();
}

}  // namespace tripoint
