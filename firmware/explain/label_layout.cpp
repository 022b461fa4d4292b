#include "explain/label_layout.h"

#include <algorithm>
#include <array>

namespace tripoint {
namespace {

/// Directions from a mark, the ones that read best first.
constexpr std::array<CanvasPoint, 8> kDirections{
    {{1.0, 0.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 0.0}, {-1.0, -1.0}, {-1.0, 1.0}, {0.0, -1.0}, {0.0, 1.0}}};
/// Gaps between mark and label; from the second on, a line leads from one to the other.
constexpr std::array<double, 3> kGaps_px{4.0, 18.0, 36.0};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool inside(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.top >= outer.top && inner.right <= outer.right &&
         inner.bottom <= outer.bottom;
}

Box box_of(const Mark& mark) {
  return {mark.at.x - mark.reach_px, mark.at.y - mark.reach_px, mark.at.x + mark.reach_px, mark.at.y + mark.reach_px};
}

Box box_beside(const Label& label, CanvasPoint direction, double gap_px) {
  const double away_px = label.mark.reach_px + gap_px;
  const double center_x = label.mark.at.x + direction.x * (away_px + 0.5 * label.width_px);
  const double center_y =
      label.mark.at.y + direction.y * (direction.x == 0.0 ? away_px + 0.5 * label.height_px : away_px);
  return {center_x - 0.5 * label.width_px, center_y - 0.5 * label.height_px, center_x + 0.5 * label.width_px,
          center_y + 0.5 * label.height_px};
}

std::optional<Box> place_of(const Label& label, const Box& room, const std::vector<Box>& taken) {
  for (const double gap_px : kGaps_px) {
    for (const CanvasPoint& direction : kDirections) {
      const Box box = box_beside(label, direction, gap_px);
      const bool hides = std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return overlap(box, other); });
      if (!hides && inside(box, room)) return box;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<Box>> places_of(std::span<const Label> labels, const Box& room, std::span<const Mark> marks) {
  std::vector<Box> taken;
  for (const Mark& mark : marks) taken.push_back(box_of(mark));
  std::vector<std::optional<Box>> places;
  for (const Label& label : labels) {
    places.push_back(place_of(label, room, taken));
    if (places.back()) taken.push_back(*places.back());
  }
  return places;
}

}  // namespace tripoint
