#include "explain/sheet.h"

#include <algorithm>

#include "explain/canvas.h"
#include "explain/look.h"

namespace tripoint {
namespace {

constexpr int kLeastWidth_px = 1100;  ///< of the contents: room for the legend
constexpr int kGap_px = 16;           ///< between close-ups, at least

struct CloseUpGrid {
  int columns = 1;
  int rows = 0;
  int step_px = 0;  ///< from one column to the next
};

/// As many columns as the width holds, from its left to its right edge.
CloseUpGrid grid_of(std::size_t close_ups, int width_px) {
  const int columns = (width_px + kGap_px) / (kCloseUpSize.width_px + kGap_px);
  return {.columns = columns,
          .rows = (static_cast<int>(close_ups) + columns - 1) / columns,
          .step_px = (width_px - kCloseUpSize.width_px) / (columns - 1)};
}

void place_close_ups(Canvas& canvas, std::span<const RgbImage> close_ups, const CloseUpGrid& grid, int top_px) {
  for (std::size_t i = 0; i < close_ups.size(); ++i) {
    const int column = static_cast<int>(i) % grid.columns;
    const int row = static_cast<int>(i) / grid.columns;
    canvas.place(close_ups[i], kMargin_px + column * grid.step_px, top_px + row * (kCloseUpSize.height_px + kGap_px));
  }
}

}  // namespace

RgbImage close_up_with(const RgbImage& pixels, Colour colour, const std::array<std::string, 3>& lines) {
  constexpr double kFirstLine_px = 18.0;
  constexpr double kLine_px = 17.0;
  constexpr int kSide_px = kCloseUpSize.width_px;
  const std::array<Type, 3> types{Type{colour, kMedium_px, true}, Type{kText, kSmall_px}, Type{kFaint, kSmall_px}};
  Canvas canvas(kCloseUpSize, kGround);
  canvas.place(pixels, 0, 0);
  canvas.fill({0.0, kSide_px, kSide_px - 1.0, kSide_px + 1.0}, colour, 1.0);
  double base_px = kSide_px + 2.0 + kFirstLine_px;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    canvas.write(fitting_text(lines[i], types[i], kSide_px), {0.0, base_px}, types[i]);
    base_px += kLine_px;
  }
  return canvas.image();
}

RgbImage sheet_of(const Heading& heading, const RgbImage& picture, std::span<const RgbImage> close_ups) {
  const int content_px = std::max(kLeastWidth_px, picture.size.width_px);
  const RgbImage head = heading_of(heading, content_px + 2 * kMargin_px);
  const int picture_bottom_px = head.size.height_px + picture.size.height_px;
  const CloseUpGrid grid = grid_of(close_ups.size(), content_px);
  Canvas canvas(
      {content_px + 2 * kMargin_px, picture_bottom_px + kMargin_px + grid.rows * (kCloseUpSize.height_px + kGap_px)},
      kGround);
  canvas.place(head, 0, 0);
  canvas.place(picture, kMargin_px, head.size.height_px);
  place_close_ups(canvas, close_ups, grid, picture_bottom_px + kMargin_px);
  return canvas.image();
}

}  // namespace tripoint
