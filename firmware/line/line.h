// The line as a reducer: same events, same measurements, on any machine.
#pragma once

#include <memory>
#include <optional>

#include "line/align/clocks.h"
#include "line/align/patience.h"
#include "line/align/tracks.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/monitor/confirmation.h"
#include "line/monitor/decalibration.h"
#include "line/monitor/monitor.h"
#include "line/observation.h"
#include "values/forecast.h"

namespace tripoint {

class Line {
 public:
  /// Without a model every verdict carries "no calibration".
  explicit Line(std::shared_ptr<const LineModel> model);

  /// @return nothing when the event brings no verdict
  std::optional<Measurement> step(const Event& event);

  /// Takes a new model between events: keeps the clocks, drops the motion and the pictures, so that no pose mixes both.
  void swap_model(std::shared_ptr<const LineModel> model);

  /// What the next pictures should show.
  [[nodiscard]] Forecast forecast() const;

 private:
  std::shared_ptr<const LineModel> model_;  // shared with whoever made it; never null
  Tracks tracks_;
  Clocks clocks_;
  Patience patience_;
  Confirmation confirmation_;
  Decalibration decalibration_;
  Monitor monitor_;
};

}  // namespace tripoint
