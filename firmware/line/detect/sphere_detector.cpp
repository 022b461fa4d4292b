#include "line/detect/sphere_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "line/detect/light.h"

namespace tripoint {
namespace {

constexpr double kCell_px = RedPatches::kCell_px;
constexpr double kWidestFocalOfWidth = 0.8;  ///< 64 degrees across: see the class
constexpr double kLargestOfMax = 2.0;        ///< radius that is still measured, to say that it is too large

/// The middle of a cell in pixels.
double px_of(int cell) { return kCell_px * cell + 0.5; }
int cell_of(double px) { return static_cast<int>(std::floor((px + 0.5) / kCell_px)); }

/// V between its samples, each of which sits in the middle of its two pixels (and two rows, when halved).
double red_at(const Picture& picture, const Vec2& at) {
  const int columns = picture.size.width_px / 2;
  const double column = std::clamp((at.x() - 0.5) / 2.0, 0.0, columns - 1.0);
  const int rows = picture.chroma_rows_halved ? picture.size.height_px / 2 : picture.size.height_px;
  const double row = std::clamp(picture.chroma_rows_halved ? (at.y() - 0.5) / 2.0 : at.y(), 0.0, rows - 1.0);
  const int x = static_cast<int>(column);
  const int y = static_cast<int>(row);
  const int next_x = std::min(x + 1, columns - 1);
  const int next_y = std::min(y + 1, rows - 1);
  const double u = column - x;
  const double v = row - y;
  return (1.0 - v) * ((1.0 - u) * picture.v.at(x, y) + u * picture.v.at(next_x, y)) +
         v * ((1.0 - u) * picture.v.at(x, next_y) + u * picture.v.at(next_x, next_y));
}

Vec2 middle_of(const RedPatch& patch) {
  return {0.5 * (px_of(patch.left) + px_of(patch.right)), 0.5 * (px_of(patch.top) + px_of(patch.bottom))};
}

double radius_of_area_px(const RedPatch& patch) { return kCell_px * std::sqrt(patch.cells / std::numbers::pi); }

bool touches_border(const RedPatch& patch, const RedPatches& patches) {
  return patch.left == 0 || patch.top == 0 || patch.right == patches.columns() - 1 ||
         patch.bottom == patches.rows() - 1;
}

/// Where V passes the middle between inside and outside, within `kReach_px` of a coarse edge; the place nearest to it.
std::optional<double> half_level_px(const Picture& picture, const Vec2& from, const Vec2& direction, double coarse_px) {
  constexpr double kReach_px = 4.0;
  constexpr double kBeyond_px = 6.0;
  constexpr double kStep_px = 0.5;
  const auto red = [&](double away_px) { return red_at(picture, from + away_px * direction); };
  const double inside = 0.5 * (red(coarse_px - kReach_px) + red(coarse_px - kBeyond_px));
  const double outside = 0.5 * (red(coarse_px + kReach_px) + red(coarse_px + kBeyond_px));
  if (inside - outside < 4.0) return std::nullopt;  // V steps: no edge of a red thing
  const double level = 0.5 * (inside + outside);
  std::optional<double> nearest;
  double before = red(coarse_px - kReach_px);
  constexpr int kSteps = static_cast<int>(2.0 * kReach_px / kStep_px);
  for (int step = 1; step <= kSteps; ++step) {
    const double away_px = coarse_px - kReach_px + step * kStep_px;
    const double here = red(away_px);
    if (before >= level && here < level) {
      const double at_px = away_px - kStep_px * (level - here) / (before - here);
      if (!nearest || std::abs(at_px - coarse_px) < std::abs(*nearest - coarse_px)) nearest = at_px;
    }
    before = here;
  }
  return nearest;
}

/// What may be wrong because the lens is not known; the formulas are those of the class.
Matrix2 lens_covariance_px2(const CircleFit& circle, double hidden, ImageSize size) {
  const double focal_px = kWidestFocalOfWidth * size.width_px;
  const Vec2 from_middle(circle.center.u_px - 0.5 * (size.width_px - 1),
                         circle.center.v_px - 0.5 * (size.height_px - 1));
  const Vec2 outwards_px = from_middle * std::pow(circle.radius_px / focal_px, 2);
  const double arc_px = hidden * circle.radius_px * from_middle.squaredNorm() / (focal_px * focal_px);
  return outwards_px * outwards_px.transpose() + arc_px * arc_px * Matrix2::Identity();
}

}  // namespace

Detection SphereDetector::detect(const Picture& picture) {
  log_.clear();
  detection_ = {};
  detection_.health.mean_luma = scene_light_of(picture).mean_luma;
  patches_.read(picture, settings_);
  const double least_px2 =
      0.5 * settings_.min_fill * std::numbers::pi * settings_.min_radius_px * settings_.min_radius_px;
  const std::vector<RedPatch> found = patches_.at_least(static_cast<int>(least_px2 / (kCell_px * kCell_px)));
  detection_.health.candidates_cut = found.size() > kMaxSphereCandidates;
  for (const RedPatch& patch : std::span(found).first(std::min(found.size(), kMaxSphereCandidates))) {
    log_.push_back(look(picture, patch));
  }
  return detection_;
}

Candidate SphereDetector::look(const Picture& picture, const RedPatch& patch) {
  Candidate seen;
  const Vec2 middle = middle_of(patch);
  seen.at = {middle.x(), middle.y()};
  seen.start_u_px = static_cast<int>(middle.x());
  seen.start_v_px = static_cast<int>(middle.y());
  seen.radius_px = static_cast<float>(radius_of_area_px(patch));
  seen.cause = judge(picture, patch, seen);
  return seen;
}

DropCause SphereDetector::judge(const Picture& picture, const RedPatch& patch, Candidate& seen) {
  if (touches_border(patch, patches_)) return DropCause::kCutByBorder;
  find_outline(picture, patch);
  const std::optional<CircleFit> circle =
      fitted_circle({outline_.begin(), outline_.size()}, kLargestOfMax * settings_.max_radius_px);
  if (!circle) return DropCause::kFitFailed;
  seen.at = circle->center;
  seen.radius_px = static_cast<float>(circle->radius_px);
  seen.outline = static_cast<float>(circle->on_circle) / static_cast<float>(kOutlineDirections);
  seen.spill = static_cast<float>(circle->beyond) / static_cast<float>(kOutlineDirections);
  seen.residual = static_cast<float>(circle->residual_px);
  if (circle->radius_px < settings_.min_radius_px || circle->radius_px > settings_.max_radius_px) {
    return DropCause::kOtherRadius;
  }
  if (static_cast<double>(seen.outline) < settings_.min_outline) return DropCause::kHiddenOutline;
  if (static_cast<double>(seen.spill) > settings_.max_spill) return DropCause::kSprawling;
  seen.fill = static_cast<float>(fill_of(patch, *circle));
  return static_cast<double>(seen.fill) < settings_.min_fill ? DropCause::kNotFilled : keep(picture, *circle, seen);
}

void SphereDetector::find_outline(const Picture& picture, const RedPatch& patch) {
  outline_.clear();
  for (std::size_t i = 0; i < kOutlineDirections; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kOutlineDirections;
    const auto edge = edge_along(picture, patch, {std::cos(angle_rad), std::sin(angle_rad)});
    if (edge) outline_.push_back(*edge);
  }
}

/// From the last red cell in this direction.
std::optional<Vec2> SphereDetector::edge_along(const Picture& picture, const RedPatch& patch,
                                               const Vec2& direction) const {
  const Vec2 middle = middle_of(patch);
  const double farthest_px = 0.5 * kCell_px * std::hypot(patch.right - patch.left + 1, patch.bottom - patch.top + 1);
  int away_px = static_cast<int>(std::ceil(farthest_px));
  for (; away_px > 0; --away_px) {
    const Vec2 at = middle + away_px * direction;
    if (patches_.label(cell_of(at.x()), cell_of(at.y())) == patch.label) break;
  }
  if (away_px <= 0) return std::nullopt;
  const std::optional<double> edge_px = half_level_px(picture, middle, direction, away_px);
  return edge_px ? std::optional<Vec2>(middle + *edge_px * direction) : std::nullopt;
}

/// Share of the circle's area that the patch covers.
double SphereDetector::fill_of(const RedPatch& patch, const CircleFit& circle) const {
  int within = 0;
  for (int row = patch.top; row <= patch.bottom; ++row) {
    for (int column = patch.left; column <= patch.right; ++column) {
      if (patches_.label(column, row) != patch.label) continue;
      const double away_px = std::hypot(px_of(column) - circle.center.u_px, px_of(row) - circle.center.v_px);
      within += away_px <= circle.radius_px ? 1 : 0;
    }
  }
  return within * kCell_px * kCell_px / (std::numbers::pi * circle.radius_px * circle.radius_px);
}

DropCause SphereDetector::keep(const Picture& picture, const CircleFit& circle, Candidate& seen) {
  const double hidden = 1.0 - static_cast<double>(seen.outline);
  const int luma = picture.luma.at(std::clamp(static_cast<int>(circle.center.u_px), 0, picture.size.width_px - 1),
                                   std::clamp(static_cast<int>(circle.center.v_px), 0, picture.size.height_px - 1));
  const ImagePoint point{.at = circle.center,
                         .covariance_px2 = circle.covariance_px2 + lens_covariance_px2(circle, hidden, picture.size) +
                                           settings_.floor_px * settings_.floor_px * Matrix2::Identity(),
                         .label = std::nullopt,
                         .sigma_px = circle.radius_px,
                         .peak = static_cast<double>(luma)};
  seen.sigma_px = static_cast<float>(circle.radius_px);
  if (detection_.points.try_push_back(point)) return DropCause::kKept;
  detection_.health.candidates_cut = true;
  return DropCause::kNoRoom;
}

}  // namespace tripoint
