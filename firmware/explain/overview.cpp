#include "explain/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "explain/label_layout.h"
#include "explain/look.h"
#include "explain/why.h"

namespace tripoint {
namespace {

constexpr std::size_t kMostLabels = 60;  ///< more hide the picture
constexpr double kMarkReach_px = 7.0;
constexpr double kPlateMargin_px = 4.0;

double mean_of(const RgbImage& image) {
  double sum = 0.0;
  for (const std::uint8_t value : image.values) sum += value;
  return image.values.empty() ? 0.0 : sum / static_cast<double>(image.values.size());
}

RgbImage shown(const RgbImage& picture, const Magnification& magnification) {
  if (magnification.reduced > 1) return reduced(picture, magnification.reduced);
  return magnification.enlarged > 1 ? enlarged(picture, magnification.enlarged) : picture;
}

/// Where a place of the picture lies in the overview; the outer edges of both are the same.
CanvasPoint shown_at(RawPixel place, double scale) {
  return {(place.u_px + 0.5) * scale - 0.5, (place.v_px + 0.5) * scale - 0.5};
}

double reach_px(const Finding& finding) {
  if (!finding.kept()) return kMarkReach_px;
  return std::max(kMarkReach_px, three_sigma(*finding.covariance_px2, kUncertaintyScale).long_px);
}

Type type_of(const Finding& finding) {
  return {colour_of(finding), finding.kept() ? kMedium_px : kSmall_px, finding.kept()};
}

std::string label_of(const Finding& finding, const DetectorSettings& settings, int width_px) {
  if (finding.kept()) return fmt::format("{}", finding.number);
  return fmt::format("{} {}: {}", finding.number, cause_in_words(finding.candidate.cause),
                     why(finding.candidate, settings, width_px));
}

void draw_leader(Canvas& canvas, const Mark& mark, const Box& box, Colour colour) {
  const CanvasPoint nearest{std::clamp(mark.at.x, box.left, box.right), std::clamp(mark.at.y, box.top, box.bottom)};
  const CanvasPoint away{nearest.x - mark.at.x, nearest.y - mark.at.y};
  const double length_px = std::hypot(away.x, away.y);
  constexpr double kShort_px = 12.0;
  if (length_px < mark.reach_px + kShort_px) return;
  const double start = mark.reach_px / length_px;
  const std::array<Stroke, 1> line{Stroke{{mark.at.x + start * away.x, mark.at.y + start * away.y}, nearest}};
  canvas.draw(line, {colour, 1.0, 1.0});
}

void draw_mark(Canvas& canvas, const Finding& finding, double scale) {
  const CanvasPoint at = shown_at(finding.candidate.at, scale);
  if (finding.kept()) {
    draw_kept(canvas, at, three_sigma(*finding.covariance_px2, kUncertaintyScale));
  } else {
    draw_dropped(canvas, at, kMarkReach_px);
  }
}

struct LabelText {
  std::string text;
  Type type;
};

void write_label(Canvas& canvas, const LabelText& label, const Box& box) {
  canvas.fill(box, kPlate, kPlateOpacity);
  canvas.write(label.text, {box.left + kPlateMargin_px, box.top + kPlateMargin_px + label.type.cap_height_px},
               label.type);
}

/// @return how many found no room
int label_all(Canvas& canvas, std::span<const Finding> findings, const std::vector<Mark>& marks,
              const std::vector<LabelText>& texts) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < std::min(findings.size(), kMostLabels); ++i) {
    const double height_px = texts[i].type.cap_height_px + 2.0 * kPlateMargin_px;
    labels.push_back({marks[i], text_width_px(texts[i].text, texts[i].type) + 2.0 * kPlateMargin_px, height_px});
  }
  const ImageSize size = canvas.image().size;
  const auto places = places_of(labels, {0.0, 0.0, size.width_px - 1.0, size.height_px - 1.0}, marks);
  auto unlabelled = static_cast<int>(findings.size() - labels.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) {
      ++unlabelled;
      continue;
    }
    draw_leader(canvas, marks[i], *places[i], texts[i].type.colour);
    write_label(canvas, texts[i], *places[i]);
  }
  return unlabelled;
}

}  // namespace

Magnification magnification_of(ImageSize size) {
  constexpr int kSmall = 1280;
  constexpr int kLarge = 1920;
  constexpr int kMostEnlarged = 8;
  const int longest = std::max({size.width_px, size.height_px, 1});
  if (longest > kLarge) return {1, (longest + kLarge - 1) / kLarge};
  return {std::clamp(kSmall / longest, 1, kMostEnlarged), 1};
}

Overview overview_of(const RgbImage& picture, std::span<const Finding> findings, const DetectorSettings& settings) {
  constexpr double kDark = 50.0;  // mean level below which the scene can hardly be made out
  Overview overview;
  overview.magnification = magnification_of(picture.size);
  RgbImage image = shown(picture, overview.magnification);
  overview.brightened = mean_of(image) < kDark;
  if (overview.brightened) image = brightened(std::move(image));

  Canvas canvas(std::move(image));
  const double scale = overview.magnification.scale();
  std::vector<Mark> marks;
  std::vector<LabelText> texts;
  for (const Finding& finding : findings) {
    marks.push_back({shown_at(finding.candidate.at, scale), reach_px(finding)});
    texts.push_back({label_of(finding, settings, picture.size.width_px), type_of(finding)});
  }
  for (std::size_t i = findings.size(); i-- > 0;) draw_mark(canvas, findings[i], scale);  // the first on top
  overview.unlabelled = label_all(canvas, findings, marks, texts);
  overview.image = canvas.image();
  return overview;
}

}  // namespace tripoint
