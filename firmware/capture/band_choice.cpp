#include "capture/band_choice.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr Duration kMostApart{70'000'000};        // two frames at 30 fps: beyond it a turn of the way is likely
constexpr double kSigmas = 4.0;                   // one spot in 16,000 lies outside
constexpr double kVelocitySigma_px_per_s = 60.0;  // of a forecast velocity: 50 ms at 2 m/s^2, seen at 400 mm
constexpr double kMostUncertain_px = 20.0;        // standard deviation: the bands would save nothing
constexpr int kLeastReach_px = 20;                // the ring of the ground around a spot of 2.5 px radius
constexpr int kSlack_px = 4;                      // a spot that grows needs more rows around it
constexpr double kMostOfPicture = 0.5;

/// Where the forecast sees a point at a time, and a standard deviation of either coordinate.
struct Expected {
  RawPixel at;
  double sigma_px = 0.0;

  [[nodiscard]] double margin_px() const { return kSigmas * sigma_px + kSlack_px; }
};

Expected expected(const ForecastPoint& point, const Forecast& forecast, Side side, TimePoint time) {
  const double after_s = seconds(time - forecast.at);
  const Vec2& velocity = point.velocity_px_per_s[side];
  const double drift_px = kVelocitySigma_px_per_s * after_s;
  return {{point.at[side].u_px + after_s * velocity.x(), point.at[side].v_px + after_s * velocity.y()},
          std::sqrt(point.covariance_px2[side].diagonal().maxCoeff() + drift_px * drift_px)};
}

bool clear_lately(const Sightings& sightings, std::uint32_t frame, std::size_t points) {
  return sightings.whole_frame && frame - *sightings.whole_frame < kFramesPerWhole && !sightings.cut &&
         sightings.spots_of_whole == points && sightings.spots == points && sightings.foreseen;
}

bool usable(const Forecast& forecast, TimePoint exposed) {
  const Duration apart = exposed - forecast.at;
  return !forecast.points.empty() && forecast.points.size() <= kMaxBands && apart <= kMostApart && apart >= -kMostApart;
}

/// Whether each spot is where the forecast has one of its points.
bool as_forecast(const Observation& seen, const Forecast& forecast) {
  return std::all_of(seen.points.begin(), seen.points.end(), [&](const ImagePoint& spot) {
    return std::any_of(forecast.points.begin(), forecast.points.end(), [&](const ForecastPoint& point) {
      const Expected place = expected(point, forecast, seen.side, seen.exposed);
      return std::abs(spot.at.u_px - place.at.u_px) <= place.margin_px() &&
             std::abs(spot.at.v_px - place.at.v_px) <= place.margin_px();
    });
  });
}

/// Nothing when no band can be expected to hold the point.
std::optional<RowBand> band_around(const Expected& place, int reach_px, ImageSize size) {
  const bool inside = place.at.u_px >= 0.0 && place.at.v_px >= 0.0 && place.at.u_px <= size.width_px - 1 &&
                      place.at.v_px <= size.height_px - 1;
  if (!inside || !(place.sigma_px <= kMostUncertain_px)) return std::nullopt;
  const double half_px = place.margin_px() + std::max(reach_px, kLeastReach_px);
  return RowBand{std::max(0, static_cast<int>(std::floor(place.at.v_px - half_px))),
                 std::min(size.height_px, static_cast<int>(std::ceil(place.at.v_px + half_px)) + 1)};
}

int rows_in(RowBands bands) {
  std::sort(bands.begin(), bands.end(), [](const RowBand& a, const RowBand& b) { return a.top_px < b.top_px; });
  int rows = 0;
  int counted_to_px = 0;
  for (const RowBand& band : bands) {
    rows += std::max(0, band.bottom_px - std::max(band.top_px, counted_to_px));
    counted_to_px = std::max(counted_to_px, band.bottom_px);
  }
  return rows;
}

}  // namespace

Sightings with(const Sightings& before, const Observation& seen, const Forecast& forecast) {
  Sightings now = before;
  if (seen.coverage == Coverage::kWholeFrame) {
    now.whole_frame = seen.frame;
    now.spots_of_whole = seen.points.size();
  }
  now.cut = seen.health.candidates_cut;
  now.spots = seen.points.size();
  now.foreseen = usable(forecast, seen.exposed) && as_forecast(seen, forecast);
  now.reach_px = std::max(0, before.reach_px - 1);
  for (const ImagePoint& point : seen.points) now.reach_px = std::max(now.reach_px, point.reach_px);
  return now;
}

RowBands chosen_bands(const Sightings& sightings, const Forecast& forecast, const NextPicture& next) {
  if (!usable(forecast, next.exposed)) return {};
  if (!clear_lately(sightings, next.frame, forecast.points.size())) return {};
  RowBands bands;
  for (const ForecastPoint& point : forecast.points) {
    const Expected place = expected(point, forecast, next.side, next.exposed);
    const std::optional<RowBand> band = band_around(place, sightings.reach_px, next.size);
    if (!band) return {};
    bands.push_back(*band);
  }
  return rows_in(bands) <= kMostOfPicture * next.size.height_px ? bands : RowBands{};
}

}  // namespace tripoint
