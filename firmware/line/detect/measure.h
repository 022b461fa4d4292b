// Where exactly a spot is: fits it on Y with its clipped core left out, or on S where Y says too little.
#pragma once

#include <cstdint>
#include <optional>

#include "line/detect/disc.h"
#include "line/detect/flood.h"
#include "line/detect/ground.h"
#include "line/detect/settings.h"
#include "line/detect/spot_fit.h"
#include "line/detect/spot_window.h"
#include "line/detect/surround.h"
#include "values/fixed_vector.h"

namespace tripoint {

/// What the gates have found of a spot: the area that stands alone at `level` of the contrast.
struct IsolatedSpot {
  const SpotWindow& window;
  const Flood& flood;  ///< holds the area
  Area area;
  Surround around;
  double level = 0.5;
  GroundPlane ground;  ///< of luma
};

struct SpotMeasurement {
  SpotFit fit;  ///< centre in the window's coordinates
  Channel channel = Channel::kLuma;
  double grain = 0.0;          ///< of the ground, standard deviation in the channel's units
  double slope_left_in = 0.0;  ///< of the ground, luma steps per px
  double share_of_radius = 0;  ///< of the fitted Gaussian at `level`, over the area's radius
  int hidden_pixels = 0;       ///< clipped, and left out of the fit
  int peak_luma = 0;
};

/// Owns the scratch memory of the fit; nothing is allocated per spot.
class SpotMeasurer {
 public:
  explicit SpotMeasurer(const LedDetectorSettings& settings) : settings_(settings) {}

  /// @return nothing when too few pixels show, or the fit leaves the spot
  std::optional<SpotMeasurement> measure(const IsolatedSpot& spot);

 private:
  void frame(const IsolatedSpot& spot);
  void fill(const IsolatedSpot& spot, Channel channel);
  void show_disc();
  void note_clipped(const IsolatedSpot& spot);
  void hide_clipped(const IsolatedSpot& spot, bool own_core);
  [[nodiscard]] SpotFit fitted_with_fading_core(const IsolatedSpot& spot, const SpotFit& first);
  std::optional<SpotMeasurement> measure_on(const IsolatedSpot& spot, Channel channel);
  [[nodiscard]] bool luma_suffices(const IsolatedSpot& spot, const SpotMeasurement& measured) const;

  LedDetectorSettings settings_;
  FitWindow fit_window_;
  SpotWindow::Part box_;                                     ///< what the fit sees,
  FixedVector<Run, 2 * SpotWindow::kMaxHalf + 1> runs_;      ///< and of it the disc
  FixedVector<std::uint16_t, SpotWindow::kPixels> clipped_;  ///< window indices
  int own_clipped_pixels_ = 0;                               ///< those of the area
  int peak_luma_ = 0;
};

}  // namespace tripoint
