// Looks closely at one place and says whether a red LED is there, where, and otherwise why not.
#pragma once

#include <cstddef>
#include <optional>

#include "line/detect/candidate.h"
#include "line/detect/flood.h"
#include "line/detect/settings.h"
#include "line/detect/spot_fit.h"
#include "line/detect/spot_window.h"
#include "line/detect/surround.h"
#include "line/observation.h"
#include "ports/frame.h"

namespace tripoint {

struct Inspection {
  Candidate candidate;
  std::optional<ImagePoint> point;  ///< when kept
};

/// Owns the scratch memory of all gates (about 150 kB); nothing is allocated per frame.
class Inspector {
 public:
  explicit Inspector(const LedDetectorSettings& settings) : settings_(settings) {}

  /// @param start  the reddest pixel of a cell
  Inspection inspect(const Picture& picture, PixelPlace start);

 private:
  enum class Channel { kLuma, kStrength };
  enum class Core { kHidden, kShown };

  DropCause judge(const Picture& picture);
  DropCause stand_out(const Picture& picture);
  DropCause isolate(const Picture& picture);
  DropCause compare_with_surround(const Picture& picture);
  DropCause fit(const Picture& picture);

  void find_peak();
  bool spread_alone(int background);
  void show_surround(const Picture& picture);
  void fill_fit_window(Channel channel);
  [[nodiscard]] bool hidden(std::size_t i) const;
  void hide_clipped(Core own_core);
  [[nodiscard]] SpotFit fitted_with_fading_core(const SpotFit& spot, Channel channel);
  std::optional<SpotFit> fit_channel(Channel channel);
  [[nodiscard]] double share_of_radius(const SpotFit& spot) const;
  [[nodiscard]] double distance_from_area_px(const SpotFit& spot) const;
  [[nodiscard]] bool luma_suffices(const SpotFit& spot) const;
  void note_fit(const SpotFit& spot, Channel channel);
  [[nodiscard]] DropCause check_fit(const SpotFit& spot, const Picture& picture) const;
  void make_point(const SpotFit& spot, Channel channel);

  LedDetectorSettings settings_;
  SpotWindow window_;
  Flood flood_;
  FitWindow fit_window_;

  // What is known of the candidate at hand.
  Candidate seen_;
  std::optional<ImagePoint> point_;
  PixelPlace peak_;
  int threshold_ = 0;
  Area area_;
  Surround around_;
  int fit_left_ = 0;
  int fit_top_ = 0;
  int peak_luma_ = 0;
  int own_hidden_pixels_ = 0;  ///< those of the area
};

}  // namespace tripoint
