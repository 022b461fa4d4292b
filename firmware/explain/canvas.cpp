#include "explain/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "explain/glyphs.h"

namespace tripoint {
namespace {

constexpr Colour kBlack{0, 0, 0};

struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;  ///< included
  int bottom = 0;
};

/// The pixels that a box touches, inside of a canvas.
PixelBox pixels_of(const Box& box, ImageSize size) {
  const auto within = [](double value, int last) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(last) + 1.0));
  };
  return {std::max(0, within(std::floor(box.left), size.width_px)),
          std::max(0, within(std::floor(box.top), size.height_px)),
          std::min(size.width_px - 1, within(std::ceil(box.right), size.width_px)),
          std::min(size.height_px - 1, within(std::ceil(box.bottom), size.height_px))};
}

Box box_around(std::span<const Stroke> strokes, double reach_px) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Box box{kFar, kFar, -kFar, -kFar};
  for (const Stroke& stroke : strokes) {
    for (const CanvasPoint& point : stroke) {
      box = {std::min(box.left, point.x - reach_px), std::min(box.top, point.y - reach_px),
             std::max(box.right, point.x + reach_px), std::max(box.bottom, point.y + reach_px)};
    }
  }
  return box;
}

double distance_px(CanvasPoint from, CanvasPoint a, CanvasPoint b) {
  const double along_x = b.x - a.x;
  const double along_y = b.y - a.y;
  const double length_squared = along_x * along_x + along_y * along_y;
  const double share =
      length_squared == 0.0 ? 0.0 : ((from.x - a.x) * along_x + (from.y - a.y) * along_y) / length_squared;
  const double nearest = std::clamp(share, 0.0, 1.0);
  return std::hypot(from.x - a.x - nearest * along_x, from.y - a.y - nearest * along_y);
}

double distance_px(CanvasPoint from, std::span<const Stroke> strokes) {
  double least = std::numeric_limits<double>::max();
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 1; i < stroke.size(); ++i)
      least = std::min(least, distance_px(from, stroke[i - 1], stroke[i]));
  }
  return least;
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, double opacity) {
  return static_cast<std::uint8_t>(std::lround(below + opacity * (above - below)));
}

double unit_px(const Type& type) { return type.cap_height_px / kCapHeight_units; }

std::vector<Stroke> strokes_of(const Glyph& glyph, CanvasPoint upper_left, double unit) {
  std::vector<Stroke> strokes(1);
  for (std::size_t i = 0; i < glyph.strokes.size(); ++i) {
    if (glyph.strokes[i] == '|') strokes.emplace_back();
    if (glyph.strokes[i] == '|' || glyph.strokes[i] == ' ') continue;
    strokes.back().push_back(
        {upper_left.x + unit * (glyph.strokes[i] - '0'), upper_left.y + unit * (glyph.strokes[i + 1] - '0')});
    ++i;
  }
  return strokes;
}

}  // namespace

double text_width_px(std::string_view text, const Type& type) { return width_units_of(text) * unit_px(type); }

std::string fitting_text(std::string_view text, const Type& type, double width_px) {
  if (text_width_px(text, type) <= width_px) return std::string{text};
  std::string shortened{text};
  while (!shortened.empty() && text_width_px(shortened + "...", type) > width_px) shortened.pop_back();
  return shortened + "...";
}

void Canvas::place(const RgbImage& image, int left, int top) {
  for (int y = std::max(0, -top); y < std::min(image.size.height_px, image_.size.height_px - top); ++y) {
    for (int x = std::max(0, -left); x < std::min(image.size.width_px, image_.size.width_px - left); ++x) {
      image_.set(left + x, top + y, image.at(x, y));
    }
  }
}

void Canvas::fill(const Box& box, Colour colour, double opacity) {
  const PixelBox pixels = pixels_of(box, image_.size);
  for (int y = pixels.top; y <= pixels.bottom; ++y) {
    for (int x = pixels.left; x <= pixels.right; ++x) blend(x, y, colour, opacity);
  }
}

void Canvas::draw(std::span<const Stroke> strokes, const Pen& pen) {
  constexpr double kHaloOpacity = 0.75;
  if (pen.halo_px > 0.0) cover(strokes, kBlack, kHaloOpacity, 0.5 * pen.width_px + pen.halo_px);
  cover(strokes, pen.colour, 1.0, 0.5 * pen.width_px);
}

/// A pixel is covered by as much as the stroke's edge lies beyond its centre, up to half a pixel on each side.
void Canvas::cover(std::span<const Stroke> strokes, Colour colour, double opacity, double half_width_px) {
  const double reach_px = half_width_px + 0.5;
  const PixelBox pixels = pixels_of(box_around(strokes, reach_px), image_.size);
  for (int y = pixels.top; y <= pixels.bottom; ++y) {
    for (int x = pixels.left; x <= pixels.right; ++x) {
      const double covered = reach_px - distance_px({static_cast<double>(x), static_cast<double>(y)}, strokes);
      if (covered > 0.0) blend(x, y, colour, opacity * std::min(covered, 1.0));
    }
  }
}

void Canvas::write(std::string_view text, CanvasPoint at, const Type& type) {
  constexpr double kStroke = 0.13;  // of the height of a capital
  constexpr double kBoldStroke = 0.2;
  const double unit = unit_px(type);
  const Pen pen{type.colour, std::max(1.0, type.cap_height_px * (type.bold ? kBoldStroke : kStroke)), 0.0};
  CanvasPoint upper_left{at.x, at.y - type.cap_height_px};
  for (const char letter : text) {
    const Glyph glyph = glyph_of(letter);
    if (!glyph.strokes.empty()) draw(strokes_of(glyph, upper_left, unit), pen);
    upper_left.x += unit * (glyph.width_units + kLetterSpace_units);
  }
}

void Canvas::blend(int x, int y, Colour colour, double opacity) {
  const Colour below = image_.at(x, y);
  image_.set(x, y,
             {mixed(below.red, colour.red, opacity), mixed(below.green, colour.green, opacity),
              mixed(below.blue, colour.blue, opacity)});
}

Stroke circle(CanvasPoint center, double radius_px) { return ellipse(center, {radius_px, radius_px, 0.0}); }

Stroke ellipse(CanvasPoint center, const EllipseShape& shape) {
  constexpr int kSides = 48;
  Stroke stroke;
  for (int i = 0; i <= kSides; ++i) {
    const double turn_rad = 2.0 * std::numbers::pi * i / kSides;
    const double along = shape.long_px * std::cos(turn_rad);
    const double across = shape.short_px * std::sin(turn_rad);
    stroke.push_back({center.x + along * std::cos(shape.angle_rad) - across * std::sin(shape.angle_rad),
                      center.y + along * std::sin(shape.angle_rad) + across * std::cos(shape.angle_rad)});
  }
  return stroke;
}

Stroke rectangle(const Box& box) {
  return {
      {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}, {box.left, box.top}};
}

}  // namespace tripoint
