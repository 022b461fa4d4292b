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
#include "explain/sheet.h"

namespace tripoint {
namespace {

constexpr std::size_t kMostCloseUps = 24;
constexpr std::size_t kMostKeptCloseUps = 12;
constexpr std::size_t kMostOfOneCause = 4;

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

std::vector<std::string> notes_on(const Explained& explained, const Overview& overview, std::size_t without_close_up) {
  std::vector<std::string> notes;
  const auto note_if = [&](bool true_of_it, std::string text) {
    if (true_of_it) notes.push_back(std::move(text));
  };
  note_if(explained.picture.v.data == nullptr, "A grey picture: nothing was looked at, it cannot show what is red.");
  note_if(explained.detection.health.candidates_cut, "More candidates than the limit: not everything was looked at.");
  note_if(overview.unlabelled > 0, fmt::format("Marks without a label: {}.", overview.unlabelled));
  note_if(without_close_up > 0, fmt::format("Candidates without a close-up: {}.", without_close_up));
  note_if(overview.picture.brightened, "A dark picture: shown brighter (gamma 2); the close-ups show it as it is.");
  return notes;
}

std::vector<Meaning> legend() {
  constexpr double kReach_px = 9.0;
  const auto kept = [](Canvas& canvas, CanvasPoint at) { draw_kept(canvas, at, {kReach_px, kReach_px, 0.0}); };
  const auto dropped = [](Canvas& canvas, CanvasPoint at) { draw_dropped(canvas, at, 7.0); };
  const auto area = [](Canvas& canvas, CanvasPoint at) {
    const std::array<Stroke, 1> strokes{circle(at, kReach_px)};
    canvas.draw(strokes, {kAreaColour, 1.0, 1.0});
  };
  return {{kept, fmt::format("kept: centre, 3 standard deviations (1 px as {:.0f})", kUncertaintyScale)},
          {dropped, "dropped: cause, measured against limit"},
          {area, "area of the spot"}};
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
  const auto kept = std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.kept(); });
  return sheet_of({.title = std::string{title},
                   .size = size_in_words(picture.size, overview.picture.magnification),
                   .kept = static_cast<int>(kept),
                   .dropped = static_cast<int>(findings.size()) - static_cast<int>(kept),
                   .causes = tally_of_dropped(findings),
                   .notes = notes_on(explained, overview, findings.size() - close_ups.size()),
                   .legend = legend()},
                  overview.picture.image, close_ups);
}

}  // namespace tripoint
