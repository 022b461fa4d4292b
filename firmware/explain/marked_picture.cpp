#include "explain/marked_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "explain/look.h"

namespace tripoint {
namespace {

constexpr std::size_t kMostLabels = 60;  ///< more hide the picture
constexpr double kPlateMargin_px = 4.0;

double mean_of(const RgbImage& image) {
  double sum = 0.0;
  for (const std::uint8_t value : image.values) sum += value;
  return image.values.empty() ? 0.0 : sum / static_cast<double>(image.values.size());
}

RgbImage magnified(const RgbImage& picture, const Magnification& magnification) {
  if (magnification.reduced > 1) return reduced(picture, magnification.reduced);
  return magnification.enlarged > 1 ? enlarged(picture, magnification.enlarged) : picture;
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

void write_label(Canvas& canvas, const MarkLabel& label, const Box& box) {
  canvas.fill(box, kPlate, kPlateOpacity);
  canvas.write(label.text, {box.left + kPlateMargin_px, box.top + kPlateMargin_px + label.type.cap_height_px},
               label.type);
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

std::string size_in_words(ImageSize size, const Magnification& magnification) {
  std::string text = fmt::format("{} x {} px", size.width_px, size.height_px);
  if (magnification.enlarged > 1) text += fmt::format(", shown x {}", magnification.enlarged);
  if (magnification.reduced > 1) text += fmt::format(", shown x 1/{}", magnification.reduced);
  return text;
}

ShownPicture shown(const RgbImage& picture) {
  constexpr double kDark = 50.0;  // mean level below which the scene can hardly be made out
  ShownPicture shown;
  shown.magnification = magnification_of(picture.size);
  shown.image = magnified(picture, shown.magnification);
  shown.brightened = mean_of(shown.image) < kDark;
  if (shown.brightened) shown.image = brightened(std::move(shown.image));
  return shown;
}

CanvasPoint shown_at(RawPixel place, double scale) {
  return {(place.u_px + 0.5) * scale - 0.5, (place.v_px + 0.5) * scale - 0.5};
}

int write_labels(Canvas& canvas, std::span<const MarkLabel> all) {
  std::vector<Mark> marks;
  std::vector<Label> labels;
  for (const MarkLabel& one : all) {
    marks.push_back(one.mark);
    if (labels.size() == kMostLabels) continue;
    const double height_px = one.type.cap_height_px + 2.0 * kPlateMargin_px;
    labels.push_back({one.mark, text_width_px(one.text, one.type) + 2.0 * kPlateMargin_px, height_px});
  }
  const ImageSize size = canvas.image().size;
  const auto places = places_of(labels, {0.0, 0.0, size.width_px - 1.0, size.height_px - 1.0}, marks);
  auto unlabelled = static_cast<int>(all.size() - labels.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) {
      ++unlabelled;
      continue;
    }
    draw_leader(canvas, all[i].mark, *places[i], all[i].type.colour);
    write_label(canvas, all[i], *places[i]);
  }
  return unlabelled;
}

}  // namespace tripoint
