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
