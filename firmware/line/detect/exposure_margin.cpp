#include "line/detect/exposure_margin.h"

#include <algorithm>
#include <array>

namespace tripoint {
namespace {

constexpr double kBlack = 16.0;
constexpr double kSpan = 219.0;

/// A channel's share of luma, and its response to a red LED over that of the red channel.
struct Channel {
  double share;
  double response;
};
constexpr std::array<Channel, 3> kChannels{{{0.299, 1.0}, {0.587, 0.06}, {0.114, 0.03}}};

}  // namespace

double level_from_luma(double luma) { return std::max(0.0, (luma - kBlack) / kSpan); }

double luma_from_led_peak(double peak) {
  double level = 0.0;
  for (const Channel& channel : kChannels) level += channel.share * std::clamp(channel.response * peak, 0.0, 1.0);
  return kBlack + kSpan * level;
}

double led_peak_from_luma(double luma) {
  double level = level_from_luma(luma);
  double peak = 0.0;
  double slope = 0.0;
  for (const Channel& channel : kChannels) slope += channel.share * channel.response;
  for (const Channel& channel : kChannels) {  // each clips later than the one before
    const double clips_at = 1.0 / channel.response;
    const double step = std::min(clips_at - peak, level / slope);
    peak += step;
    level -= step * slope;
    slope -= channel.share * channel.response;
    if (peak < clips_at) break;
  }
  return peak;
}

ExposureMargin exposure_margin(double dimmest_luma, double brightest_luma) {
  constexpr double kLeast = 0.01;  // a division by zero would be no margin
  return {.above_dim = led_peak_from_luma(dimmest_luma) / kDimmestLedPeak,
          .below_clipping = kBrightestLedPeak / std::max(kLeast, led_peak_from_luma(brightest_luma))};
}

}  // namespace tripoint
