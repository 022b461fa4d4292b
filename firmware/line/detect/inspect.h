// Looks closely at one place and says whether a red LED is there, where, and otherwise why not.
#pragma once

#include <optional>

#include "line/detect/candidate.h"
#include "line/detect/flood.h"
#include "line/detect/measure.h"
#include "line/detect/settings.h"
#include "line/detect/spot_window.h"
#include "line/detect/surround.h"
#include "line/observation.h"
#include "ports/frame.h"

namespace tripoint {

struct Inspection {
  Candidate candidate;
  std::optional<ImagePoint> point;  ///< when kept
  RowBand looked;                   ///< the rows that had a say; may end outside the picture
};

/// Owns the scratch memory of all gates (about 150 kB); nothing is allocated per frame.
class Inspector {
 public:
  explicit Inspector(const LedDetectorSettings& settings) : settings_(settings), measurer_(settings) {}

  /// @param start  the reddest pixel of a cell
  Inspection inspect(const Picture& picture, PixelPlace start);

 private:
  DropCause judge(const Picture& picture);
  DropCause stand_out(const Picture& picture);
  DropCause isolate(const Picture& picture);
  DropCause compare_with_surround(const Picture& picture);
  DropCause fit(const Picture& picture);

  void look_at_rows(int middle_px, int reach_px);
  void find_peak();
  SpotWindow::Part part_around_start(const Picture& picture, int half);
  bool spread_alone(const SpotWindow::Part& part, int background);
  void show_surround(const Picture& picture);
  void note(const SpotMeasurement& measured);
  [[nodiscard]] DropCause check(const SpotMeasurement& measured, const Picture& picture) const;
  void make_point(const SpotMeasurement& measured, const Picture& picture);

  LedDetectorSettings settings_;
  SpotWindow window_;
  Flood flood_;
  SpotMeasurer measurer_;

  // What is known of the candidate at hand.
  Candidate seen_;
  std::optional<ImagePoint> point_;
  RowBand looked_;  // may end outside the picture
  int half_loaded_ = 0;
  PixelPlace peak_;
  int threshold_ = 0;
  Area area_;
  Surround around_;
};

}  // namespace tripoint
