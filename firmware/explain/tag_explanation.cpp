#include "explain/tag_explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "explain/look.h"
#include "explain/marked_picture.h"
#include "explain/sheet.h"

namespace tripoint {
namespace {

constexpr std::size_t kMostCloseUps = 24;
constexpr int kSide_px = kCloseUpSize.width_px;

bool measured(const SeenTag& tag) { return tag.outline.cause == TagCause::kKept; }

Colour colour_of(const SeenTag& tag) { return measured(tag) ? kKeptColour : kDroppedColour; }

/// Measured ones first, each by their ids.
std::vector<const SeenTag*> by_interest(const SeenTags& seen) {
  std::vector<const SeenTag*> tags;
  for (const SeenTag& tag : seen.tags) tags.push_back(&tag);
  std::stable_partition(tags.begin(), tags.end(), [](const SeenTag* tag) { return measured(*tag); });
  return tags;
}

std::string in_words(TagCause cause) {
  std::string words{name(cause)};
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

RawPixel middle_of(const SeenTag& tag) { return centre_of(tag.outline).at; }

/// From the middle to the farthest corner.
double reach_px(const SeenTag& tag) {
  const RawPixel middle = middle_of(tag);
  double reach_px = 0.0;
  for (const RawPixel& corner : tag.outline.corners_px) {
    reach_px = std::max(reach_px, std::hypot(corner.u_px - middle.u_px, corner.v_px - middle.v_px));
  }
  return reach_px;
}

double shortest_edge_px(const SeenTag& tag) {
  const auto& corners = tag.outline.corners_px;
  double shortest_px = std::hypot(corners[0].u_px - corners[3].u_px, corners[0].v_px - corners[3].v_px);
  for (std::size_t k = 0; k + 1 < kTagCorners; ++k) {
    shortest_px =
        std::min(shortest_px, std::hypot(corners[k + 1].u_px - corners[k].u_px, corners[k + 1].v_px - corners[k].v_px));
  }
  return shortest_px;
}

/// Of its worst corner, along its worst direction.
double sigma_px(const SeenTag& tag) {
  double sigma_px = 0.0;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    sigma_px = std::max(sigma_px, three_sigma(corner_of(tag.outline, k).covariance_px2, 1.0).long_px / 3.0);
  }
  return sigma_px;
}

/// The outline, its first corner with a dot, and what the corners may err by.
///
/// @param on_canvas  where a place of the picture lies
template <typename OnCanvas>
void draw_tag(Canvas& canvas, const SeenTag& tag, OnCanvas on_canvas) {
  constexpr double kDot_px = 3.5;
  std::array<CanvasPoint, kTagCorners> corners;
  std::transform(tag.outline.corners_px.begin(), tag.outline.corners_px.end(), corners.begin(), on_canvas);
  // One by one: the pen's time goes with the box around all that it draws at once.
  const auto draw = [&](const Stroke& stroke) { canvas.draw(std::array{stroke}, {colour_of(tag), 1.5, kHalo_px}); };
  for (std::size_t k = 0; k < kTagCorners; ++k) draw({corners[k], corners[(k + 1) % kTagCorners]});
  draw(circle(corners[0], kDot_px));
  for (std::size_t k = 0; measured(tag) && k < kTagCorners; ++k) {
    draw(ellipse(corners[k], three_sigma(corner_of(tag.outline, k).covariance_px2, kUncertaintyScale)));
  }
}

/// Enlarged by whole pixels or reduced by whole divisors, so that the tag and its rim fill most of a square.
RgbImage pixels_around(const RgbImage& picture, const SeenTag& tag) {
  constexpr double kRim = 1.3;
  const double side_px = std::max(2.0 * kRim * reach_px(tag), 1.0);
  const int enlarged_by = std::clamp(static_cast<int>(kSide_px / side_px), 1, 8);
  const int reduced_by = std::max(1, static_cast<int>(std::ceil(side_px / kSide_px)));
  const int cut_px = kSide_px * reduced_by / enlarged_by;
  const RawPixel middle = middle_of(tag);
  const PixelPlace center{static_cast<int>(std::lround(middle.u_px)), static_cast<int>(std::lround(middle.v_px))};
  const RgbImage cut = cut_out(picture, center, cut_px, kOutside);
  Canvas canvas(plain_image({kSide_px, kSide_px}, kOutside));
  canvas.place(reduced_by > 1 ? reduced(cut, reduced_by) : enlarged(cut, enlarged_by), 0, 0);
  const double scale = static_cast<double>(enlarged_by) / reduced_by;
  const int middle_px = cut_px / 2;
  draw_tag(canvas, tag, [&](RawPixel place) {
    return shown_at({place.u_px - center.u_px + middle_px, place.v_px - center.v_px + middle_px}, scale);
  });
  return canvas.image();
}

RgbImage close_up_of(const RgbImage& picture, const SeenTag& tag, double min_margin) {
  const int mended = tag.decoded.corrected_bits;
  return close_up_with(pixels_around(picture, tag), colour_of(tag),
                       {fmt::format("{} {}", tag.decoded.id, in_words(tag.outline.cause)), why(tag, min_margin),
                        fmt::format("{:.0f} px, margin {:.0f}{}", shortest_edge_px(tag), tag.decoded.margin,
                                    mended > 0 ? fmt::format(", {} mended", mended) : "")});
}

/// "2 unsure bits, 1 crooked edge"
std::string tally_of_rough(const SeenTags& seen) {
  std::map<TagCause, int> counts;
  for (const SeenTag& tag : seen.tags) counts[tag.outline.cause] += measured(tag) ? 0 : 1;
  std::string text;
  for (const auto& [cause, count] : counts) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, in_words(cause));
  }
  return text;
}

std::vector<Meaning> legend() {
  constexpr double kReach_px = 8.0;
  const auto box = [](Canvas& canvas, CanvasPoint at, Colour colour) {
    const Box around{at.x - kReach_px, at.y - kReach_px, at.x + kReach_px, at.y + kReach_px};
    const std::array<Stroke, 2> strokes{rectangle(around), circle({around.left, around.bottom}, 3.0)};
    canvas.draw(strokes, {colour, 1.5, kHalo_px});
  };
  const auto kept = [box](Canvas& canvas, CanvasPoint at) { box(canvas, at, kKeptColour); };
  const auto rough = [box](Canvas& canvas, CanvasPoint at) { box(canvas, at, kDroppedColour); };
  return {{kept, fmt::format("kept: first corner dotted, 3 standard deviations (1 px as {:.0f})", kUncertaintyScale)},
          {rough, "no part of a pose: cause"}};
}

}  // namespace

std::string why(const SeenTag& tag, double min_margin) {
  switch (tag.outline.cause) {
    case TagCause::kKept:
      return fmt::format("corners' sd up to {:.3f} px", sigma_px(tag));
    case TagCause::kUnsureBits:
      return fmt::format("margin {:.1f} < {:.1f}", tag.decoded.margin, min_margin);
    case TagCause::kTooSmall:
      return fmt::format("edge of {:.0f} px", shortest_edge_px(tag));
    case TagCause::kCutByBorder:
      return "the picture ends too near";
    case TagCause::kNoContrast:
      return "no step across an edge";
    case TagCause::kCrookedEdge:
      return "an edge is bent or hidden";
    case TagCause::kBlurred:
      return "an edge is too wide";
    case TagCause::kUnevenLight:
      return "light beside an edge is uneven";
    case TagCause::kMovedCorner:
      return "edges meet beside a corner";
    case TagCause::kShiftedCells:
      return "cells lie beside their places";
  }
  return "";
}

RgbImage explanation_of(const Picture& picture, const SeenTags& seen, double min_margin, std::string_view title) {
  const RgbImage image = rgb_of(picture);
  ShownPicture overview = shown(image);
  const double scale = overview.magnification.scale();
  Canvas canvas(std::move(overview.image));
  std::vector<MarkLabel> labels;
  std::vector<RgbImage> close_ups;
  int kept = 0;
  for (const SeenTag* tag : by_interest(seen)) {
    kept += measured(*tag) ? 1 : 0;
    draw_tag(canvas, *tag, [&](RawPixel place) { return shown_at(place, scale); });
    const std::string text = measured(*tag) ? fmt::format("{}", tag->decoded.id)
                                            : fmt::format("{} {}", tag->decoded.id, in_words(tag->outline.cause));
    labels.push_back({{shown_at(middle_of(*tag), scale), scale * reach_px(*tag)},
                      text,
                      {colour_of(*tag), kMedium_px, measured(*tag)}});
    if (close_ups.size() < kMostCloseUps) close_ups.push_back(close_up_of(image, *tag, min_margin));
  }
  std::vector<std::string> notes;
  if (const int unlabelled = write_labels(canvas, labels); unlabelled > 0) {
    notes.push_back(fmt::format("Tags without a label: {}.", unlabelled));
  }
  if (seen.cut) notes.emplace_back("More tags than the limit: not all are shown.");
  if (overview.brightened)
    notes.emplace_back("A dark picture: shown brighter (gamma 2); the close-ups show it as it is.");
  return sheet_of({.title = std::string{title},
                   .size = size_in_words(image.size, overview.magnification),
                   .kept = kept,
                   .dropped = static_cast<int>(seen.tags.size()) - kept,
                   .causes = tally_of_rough(seen),
                   .notes = notes,
                   .legend = legend()},
                  canvas.image(), close_ups);
}

}  // namespace tripoint
