#include "explain/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "explain/look.h"
#include "explain/why.h"

namespace tripoint {
namespace {

constexpr double kMarkReach_px = 7.0;

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

void draw_mark(Canvas& canvas, const Finding& finding, double scale) {
  const CanvasPoint at = shown_at(finding.candidate.at, scale);
  if (finding.kept()) {
    draw_kept(canvas, at, three_sigma(*finding.covariance_px2, kUncertaintyScale));
  } else {
    draw_dropped(canvas, at, kMarkReach_px);
  }
}

}  // namespace

Overview overview_of(const RgbImage& picture, std::span<const Finding> findings, const DetectorSettings& settings) {
  Overview overview{.picture = shown(picture)};
  Canvas canvas(std::move(overview.picture.image));
  const double scale = overview.picture.magnification.scale();
  std::vector<MarkLabel> labels;
  for (const Finding& finding : findings) {
    labels.push_back({{shown_at(finding.candidate.at, scale), reach_px(finding)},
                      label_of(finding, settings, picture.size.width_px),
                      type_of(finding)});
  }
  for (std::size_t i = findings.size(); i-- > 0;) draw_mark(canvas, findings[i], scale);  // the first on top
  overview.unlabelled = write_labels(canvas, labels);
  overview.picture.image = canvas.image();
  return overview;
}

}  // namespace tripoint
