#include "tags/edge_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr std::size_t kFewestCrossings = 5;
constexpr double kSpacing_px = 1.5;       // apart enough that the noise of one says little of the next
constexpr double kCornerMargin_px = 2.0;  // blur rounds the corners
constexpr double kStep_px = 0.5;          // across the edge
constexpr double kWidestReach_px = 4.0;
constexpr double kLeastContrast = 10.0;  // luma steps: five times the noise of a cheap camera
constexpr double kShareSeen = 0.6;       // of the crossings; fewer, and a part of the edge is hidden
// Second moment of the slope over the square of the reach. A slope that fills all that is looked at has 1/3, wherever
// the edge lies; at a fifth (a blur of 1.3 px seen over 2.5 px) each look takes off three quarters of what the last
// erred.
constexpr double kWidestSlope = 0.2;
// Of the contrast. Noise of 2 luma steps is 0.02 of a contrast of 60. What changes the light at the end of the reach by
// so much moves a crossing by as much of the reach, 0.15 px.
constexpr double kMostUneven = 0.06;
constexpr double kOutlier = 3.0;           // deviations
constexpr double kLeastScatter_px = 0.02;  // of a crossing: what interpolation between pixels errs by

struct Crossing {
  double along_px = 0.0;
  double across_px = 0.0;
  double width_px2 = 0.0;  // second moment of the slope
  double inside = 0.0;     // luma
  double outside = 0.0;    // luma
};
using Crossings = FixedVector<Crossing, kMostCrossings>;

/// The edge's own axes.
struct Axes {
  Vec2 from_px;
  Vec2 along;
  Vec2 outwards;
  double length_px = 0.0;
};

Axes axes_of(const RoughEdge& edge) {
  const Vec2 way_px = edge.to_px - edge.from_px;
  const double length_px = way_px.norm();
  const Vec2 along = way_px / std::max(length_px, 1e-9);
  return {edge.from_px, along, {-along.y(), along.x()}, length_px};
}

int steps_to_each_side(const RoughEdge& edge) {
  return std::max(2, static_cast<int>(std::lround(std::min(edge.reach_px, kWidestReach_px) / kStep_px)));
}

enum class Look { kSeen, kBorder, kFlat };

/// One line across the edge: the centroid of the slope of the luma from the inside to the outside.
Look look_across(const LumaView& luma, const RoughEdge& edge, const Axes& axes, Crossing& crossing) {
  const Vec2 middle_px = axes.from_px + crossing.along_px * axes.along;
  const int steps = steps_to_each_side(edge);
  const double reach_px = steps * kStep_px;
  const std::size_t samples = 2 * static_cast<std::size_t>(steps) + 1;
  const std::optional<LumaProfile> profile =
      luma.along(middle_px - reach_px * axes.outwards, middle_px + reach_px * axes.outwards, samples);
  if (!profile) return Look::kBorder;
  double moment = 0.0;
  double second_moment = 0.0;
  for (std::size_t i = 1; i < samples; ++i) {
    const auto slope = static_cast<double>((*profile)[i] - (*profile)[i - 1]);
    const double across_px = (static_cast<double>(i) - 0.5) * kStep_px - reach_px;
    moment += slope * across_px;
    second_moment += slope * across_px * across_px;
  }
  crossing.inside = static_cast<double>((*profile)[0]);
  crossing.outside = static_cast<double>(profile->back());
  const double rise = crossing.outside - crossing.inside;
  if ((edge.light_inside ? -rise : rise) < kLeastContrast) return Look::kFlat;
  crossing.across_px = moment / rise;
  crossing.width_px2 = second_moment / rise - crossing.across_px * crossing.across_px;
  return std::abs(crossing.across_px) < reach_px ? Look::kSeen : Look::kFlat;
}

struct Line {
  double mean_along_px = 0.0;
  double mean_across_px = 0.0;
  double slope = 0.0;
  double spread_px2 = 0.0;  // sum of squares along
  double scatter_px = 0.0;  // of a crossing about the line
};

Line line_through(std::span<const Crossing> crossings) {
  Line line;
  const auto count = static_cast<double>(crossings.size());
  for (const Crossing& crossing : crossings) {
    line.mean_along_px += crossing.along_px / count;
    line.mean_across_px += crossing.across_px / count;
  }
  double mixed_px2 = 0.0;
  for (const Crossing& crossing : crossings) {
    const double along_px = crossing.along_px - line.mean_along_px;
    line.spread_px2 += along_px * along_px;
    mixed_px2 += along_px * (crossing.across_px - line.mean_across_px);
  }
  line.slope = mixed_px2 / line.spread_px2;
  double squares_px2 = 0.0;
  for (const Crossing& crossing : crossings) {
    const double off_px =
        crossing.across_px - line.mean_across_px - line.slope * (crossing.along_px - line.mean_along_px);
    squares_px2 += off_px * off_px;
  }
  line.scatter_px = std::sqrt(squares_px2 / (count - 2.0));
  return line;
}

double off_line_px(const Crossing& crossing, const Line& line) {
  return std::abs(crossing.across_px - line.mean_across_px - line.slope * (crossing.along_px - line.mean_along_px));
}

/// Those within three deviations of the line through all, the deviation taken from the median.
Crossings without_outliers(const Crossings& all) {
  const Line line = line_through({all.begin(), all.size()});
  std::array<double, kMostCrossings> off_px{};
  for (std::size_t i = 0; i < all.size(); ++i) off_px[i] = off_line_px(all[i], line);
  std::array<double, kMostCrossings> sorted_px = off_px;
  auto* const middle = sorted_px.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(sorted_px.begin(), middle, sorted_px.begin() + static_cast<std::ptrdiff_t>(all.size()));
  const double deviation_px = std::max(1.4826 * *middle, kLeastScatter_px);  // of a normal distribution
  Crossings kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (off_px[i] <= kOutlier * deviation_px) kept.push_back(all[i]);
  }
  return kept;
}

EdgeFit refused(TagCause cause) { return {cause, {}}; }

double mean_width_px2(const Crossings& crossings) {
  double sum_px2 = 0.0;
  for (const Crossing& crossing : crossings) sum_px2 += crossing.width_px2;
  return sum_px2 / static_cast<double>(crossings.size());
}

/// @param line  through the crossings: where they are along the edge
LightBeside light_beside(const Crossings& crossings, const Line& line, double Crossing::*side, double length_px) {
  LightBeside beside;
  const auto count = static_cast<double>(crossings.size());
  double mixed = 0.0;
  for (const Crossing& crossing : crossings) {
    beside.mean += crossing.*side / count;
    mixed += crossing.*side * (crossing.along_px - line.mean_along_px);
  }
  const double per_px = mixed / line.spread_px2;
  double squares = 0.0;
  for (const Crossing& crossing : crossings) {
    squares += std::pow(crossing.*side - beside.mean - per_px * (crossing.along_px - line.mean_along_px), 2);
  }
  beside.at_from = beside.mean - per_px * line.mean_along_px;
  beside.at_to = beside.mean + per_px * (length_px - line.mean_along_px);
  beside.scatter = std::sqrt(squares / (count - 2.0));
  return beside;
}

EdgeFit fit_of(const Crossings& crossings, const RoughEdge& edge, const Axes& axes) {
  const Line line = line_through({crossings.begin(), crossings.size()});
  if (line.scatter_px > edge.most_scatter_px) return refused(TagCause::kCrookedEdge);
  if (!(mean_width_px2(crossings) <= kWidestSlope * std::pow(steps_to_each_side(edge) * kStep_px, 2))) {
    return refused(TagCause::kBlurred);
  }
  const double variance_px2 = std::pow(std::max(line.scatter_px, kLeastScatter_px), 2);
  EdgeFit fit;
  fit.line.middle_px = axes.from_px + line.mean_along_px * axes.along + line.mean_across_px * axes.outwards;
  fit.line.along = (axes.along + line.slope * axes.outwards).normalized();
  fit.line.across_variance_px2 = variance_px2 / static_cast<double>(crossings.size());
  fit.line.angle_variance_rad2 = variance_px2 / line.spread_px2;
  const LightBeside inside = light_beside(crossings, line, &Crossing::inside, axes.length_px);
  const LightBeside outside = light_beside(crossings, line, &Crossing::outside, axes.length_px);
  fit.line.light = edge.light_inside ? inside : outside;
  fit.line.dark = edge.light_inside ? outside : inside;
  const double contrast = fit.line.light.mean - fit.line.dark.mean;
  const double scatter = std::max(inside.scatter, outside.scatter);
  if (edge.even_light && !(scatter <= kMostUneven * contrast)) return refused(TagCause::kUnevenLight);
  return fit;
}

}  // namespace

EdgeFit edge_line(const LumaView& luma, const RoughEdge& edge) {
  const Axes axes = axes_of(edge);
  const double usable_px = axes.length_px - 2.0 * kCornerMargin_px;
  const auto most = static_cast<double>(std::min(edge.most_crossings, kMostCrossings));
  const auto planned = static_cast<std::size_t>(std::clamp(usable_px / kSpacing_px + 1.0, 0.0, most));
  if (usable_px <= 0.0 || planned < kFewestCrossings) return refused(TagCause::kTooSmall);

  Crossings seen;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < planned; ++i) {
    Crossing crossing;
    crossing.along_px = kCornerMargin_px + usable_px * static_cast<double>(i) / (static_cast<double>(planned) - 1.0);
    const Look look = look_across(luma, edge, axes, crossing);
    if (look == Look::kSeen) seen.push_back(crossing);
    if (look == Look::kBorder) ++beyond;
  }
  const std::size_t needed =
      std::max(kFewestCrossings, static_cast<std::size_t>(kShareSeen * static_cast<double>(planned)));
  if (seen.size() < needed) return refused(beyond > 0 ? TagCause::kCutByBorder : TagCause::kNoContrast);
  const Crossings kept = without_outliers(seen);
  if (kept.size() < needed) return refused(TagCause::kCrookedEdge);
  return fit_of(kept, edge, axes);
}

}  // namespace tripoint
