// Drawing with smooth edges: strokes of a pen, plates, letters and images.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "explain/rgb_image.h"

namespace tripoint {

/// A place on a canvas, px, pixel centres at integers.
struct CanvasPoint {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

/// The pen goes from each point to the next.
using Stroke = std::vector<CanvasPoint>;

struct Pen {
  Colour colour;
  double width_px = 1.5;
  double halo_px = 0.0;  ///< of black around it: stands out on every ground
};

struct Type {
  Colour colour;
  double cap_height_px = 9.0;
  bool bold = false;
};

/// Width of the text as it is drawn, px.
double text_width_px(std::string_view text, const Type& type);

/// The text, or its beginning and "..." where it would be wider.
std::string fitting_text(std::string_view text, const Type& type, double width_px);

class Canvas {
 public:
  Canvas(ImageSize size, Colour ground) : image_(plain_image(size, ground)) {}
  explicit Canvas(RgbImage ground) : image_(std::move(ground)) {}

  /// Its upper left pixel at `left`, `top`; what lies outside of the canvas is cut off.
  void place(const RgbImage& image, int left, int top);
  /// @param opacity  1 hides what is below
  void fill(const Box& box, Colour colour, double opacity);
  void draw(std::span<const Stroke> strokes, const Pen& pen);
  /// @param at  left end of the line on which the letters stand
  void write(std::string_view text, CanvasPoint at, const Type& type);

  [[nodiscard]] const RgbImage& image() const { return image_; }

 private:
  void cover(std::span<const Stroke> strokes, Colour colour, double opacity, double half_width_px);
  void blend(int x, int y, Colour colour, double opacity);

  RgbImage image_;
};

struct EllipseShape {
  double long_px = 0.0;  ///< half axes
  double short_px = 0.0;
  double angle_rad = 0.0;  ///< of the long axis, from x to y
};

Stroke ellipse(CanvasPoint center, const EllipseShape& shape);
Stroke circle(CanvasPoint center, double radius_px);
Stroke rectangle(const Box& box);

}  // namespace tripoint
