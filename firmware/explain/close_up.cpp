#include "explain/close_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "explain/look.h"
#include "explain/why.h"

namespace tripoint {
namespace {

constexpr int kSide_px = kCloseUpSize.width_px;
constexpr std::array<int, 4> kZooms{8, 4, 2, 1};  ///< without remainder in kSide_px

/// What must be seen to understand the verdict, px of the picture.
double extent_px(const Candidate& candidate) {
  constexpr double kSurface_px = 50.0;
  constexpr double kOfRadius = 3.2;
  const bool surface = candidate.cause == DropCause::kNoFalloff || candidate.cause == DropCause::kTooLarge;
  return surface ? kSurface_px : kOfRadius * static_cast<double>(candidate.radius_px);
}

int zoom_of(const Candidate& candidate) {
  const double extent = extent_px(candidate);
  const auto* const fitting = std::find_if(kZooms.begin(), kZooms.end(),
                                           [&](int zoom) { return static_cast<double>(kSide_px) / zoom >= extent; });
  return fitting == kZooms.end() ? kZooms.back() : *fitting;
}

void draw_area(Canvas& canvas, CanvasPoint at, double radius_px) {
  if (radius_px <= 0.0) return;
  const std::array<Stroke, 1> strokes{circle(at, radius_px)};
  canvas.draw(strokes, {kAreaColour, 1.0, 1.0});
}

/// Four corners around the place, so that the pixels themselves stay visible.
void draw_corners(Canvas& canvas, CanvasPoint at) {
  constexpr double kReach_px = 16.0;
  constexpr double kLength_px = 7.0;
  std::array<Stroke, 4> strokes;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double x = i % 2 == 0 ? -1.0 : 1.0;
    const double y = i < 2 ? -1.0 : 1.0;
    strokes[i] = {{at.x + x * (kReach_px - kLength_px), at.y + y * kReach_px},
                  {at.x + x * kReach_px, at.y + y * kReach_px},
                  {at.x + x * kReach_px, at.y + y * (kReach_px - kLength_px)}};
  }
  canvas.draw(strokes, {kDroppedColour, 1.5, kHalo_px});
}

RgbImage pixels_around(const RgbImage& picture, const Finding& finding) {
  const Candidate& candidate = finding.candidate;
  const int zoom = zoom_of(candidate);
  const int side = kSide_px / zoom;
  const PixelPlace center{static_cast<int>(std::lround(candidate.at.u_px)),
                          static_cast<int>(std::lround(candidate.at.v_px))};
  Canvas canvas(enlarged(cut_out(picture, center, side, kOutside), zoom));
  const int middle = side / 2;
  const CanvasPoint at{(candidate.at.u_px - center.u_px + middle + 0.5) * zoom - 0.5,
                       (candidate.at.v_px - center.v_px + middle + 0.5) * zoom - 0.5};
  draw_area(canvas, at, static_cast<double>(candidate.radius_px) * zoom);
  if (finding.kept()) {
    draw_kept(canvas, at, three_sigma(*finding.covariance_px2, kUncertaintyScale));
  } else {
    draw_corners(canvas, at);
  }
  if (zoom != kZooms.front()) {
    canvas.fill({0.0, 0.0, 34.0, 20.0}, kPlate, kPlateOpacity);
    canvas.write(fmt::format("x {}", zoom), {6.0, 15.0}, {kText, kSmall_px});
  }
  return canvas.image();
}

std::string place_of(const Finding& finding) {
  const RawPixel& at = finding.candidate.at;
  if (!finding.kept()) return fmt::format("at {:.0f}, {:.0f}", at.u_px, at.v_px);
  const double sigma_px = three_sigma(*finding.covariance_px2, 1.0).long_px / 3.0;
  return fmt::format("at {:.2f}, {:.2f} sd {:.2f}", at.u_px, at.v_px, sigma_px);
}

}  // namespace

RgbImage close_up_of(const RgbImage& picture, const Finding& finding, const DetectorSettings& settings) {
  return close_up_with(pixels_around(picture, finding), colour_of(finding),
                       {fmt::format("{} {}", finding.number, cause_in_words(finding.candidate.cause)),
                        why(finding.candidate, settings, picture.size.width_px), place_of(finding)});
}

}  // namespace tripoint
