#include "explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "explain/close_up.h"
#include "explain/finding.h"
#include "explain/heading.h"
#include "explain/look.h"
#include "explain/overview.h"

namespace tripoint {
namespace {

constexpr int kLeastWidth_px = 1100;  ///< of the contents: room for the legend
constexpr std::size_t kMostCloseUps = 24;
constexpr std::size_t kMostKeptCloseUps = 12;
constexpr std::size_t kMostOfOneCause = 4;
constexpr int kGap_px = 16;  ///< between close-ups, at least

/// Kept ones first; of the dropped ones not too many that say the same.
std::vector<Finding> telling_ones(std::span<const Finding> findings) {
  std::vector<Finding> kept;
  std::vector<Finding> dropped;
  std::array<std::size_t, kDropCauseNames.size()> of_cause{};
  for (const Finding& finding : findings) {
    if (finding.kept()) {
      kept.push_back(finding);
    } else if (++of_cause[static_cast<std::size_t>(finding.candidate.cause)] <= kMostOfOneCause) {
      dropped.push_back(finding);
    }
  }
  kept.resize(std::min(kept.size(), kMostKeptCloseUps));
  dropped.resize(std::min(dropped.size(), kMostCloseUps - kept.size()));
  kept.insert(kept.end(), dropped.begin(), dropped.end());
  return kept;
}

std::string size_in_words(ImageSize size, const Magnification& magnification) {
  std::string text = fmt::format("{} x {} px", size.width_px, size.height_px);
  if (magnification.enlarged > 1) text += fmt::format(", shown x {}", magnification.enlarged);
  if (magnification.reduced > 1) text += fmt::format(", shown x 1/{}", magnification.reduced);
  return text;
}

std::vector<std::string> notes_on(const Explained& explained, const Overview& overview, std::size_t without_close_up) {
  std::vector<std::string> notes;
  const auto note_if = [&](bool true_of_it, std::string text) {
    if (true_of_it) notes.push_back(std::move(text));
  };
  note_if(explained.picture.v.data == nullptr, "A grey picture: nothing was looked at, it cannot show what is red.");
  note_if(explained.detection.health.candidates_cut, "More candidates than the limit: not everything was looked at.");
  note_if(overview.unlabelled > 0, fmt::format("Marks without a label: {}.", overview.unlabelled));
  note_if(without_close_up > 0, fmt::format("Candidates without a close-up: {}.", without_close_up));
  note_if(overview.brightened, "A dark picture: shown brighter (gamma 2); the close-ups show it as it is.");
  return notes;
}

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

void place_close_ups(Canvas& canvas, const std::vector<RgbImage>& close_ups, const CloseUpGrid& grid, int top_px) {
  for (std::size_t i = 0; i < close_ups.size(); ++i) {
    const int column = static_cast<int>(i) % grid.columns;
    const int row = static_cast<int>(i) / grid.columns;
    canvas.place(close_ups[i], kMargin_px + column * grid.step_px, top_px + row * (kCloseUpSize.height_px + kGap_px));
  }
}

}  // namespace

RgbImage explanation_of(const Explained& explained, std::string_view title) {
  const RgbImage picture = rgb_of(explained.picture);
  const std::vector<Finding> findings = findings_of(explained.log, explained.detection);
  const Overview overview = overview_of(picture, findings, explained.settings);
  std::vector<RgbImage> close_ups;
  for (const Finding& finding : telling_ones(findings)) {
    close_ups.push_back(close_up_of(picture, finding, explained.settings));
  }
  const int content_px = std::max(kLeastWidth_px, overview.image.size.width_px);
  const RgbImage heading = heading_of({.title = std::string{title},
                                       .size = size_in_words(picture.size, overview.magnification),
                                       .notes = notes_on(explained, overview, findings.size() - close_ups.size())},
                                      findings, content_px + 2 * kMargin_px);
  const int picture_bottom_px = heading.size.height_px + overview.image.size.height_px;
  const CloseUpGrid grid = grid_of(close_ups.size(), content_px);
  Canvas canvas(
      {content_px + 2 * kMargin_px, picture_bottom_px + kMargin_px + grid.rows * (kCloseUpSize.height_px + kGap_px)},
      kGround);
  canvas.place(heading, 0, 0);
  canvas.place(overview.image, kMargin_px, heading.size.height_px);
  place_close_ups(canvas, close_ups, grid, picture_bottom_px + kMargin_px);
  return canvas.image();
}

}  // namespace tripoint
