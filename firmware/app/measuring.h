// The measuring thread: events in, verdicts out to whoever reads registers, forecasts back to the cameras.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "app/camera_log.h"
#include "app/unit_report.h"
#include "capture/camera_worker.h"
#include "line/line.h"
#include "line/model.h"
#include "line/observation.h"
#include "ports/clock.h"
#include "serve/publication.h"
#include "values/bounded_queue.h"
#include "values/latest.h"

namespace tripoint {

/// What the measuring thread shares with others; all of it outlives it.
struct MeasuringLinks {
  BoundedQueue<Event>& events;
  const PerSide<Latest<CameraStatus>>& cameras;
  Latest<Forecast>& forecast;
  Publication& publication;
  const Clock& clock;
};

/// Says whether a calibration belongs to the cameras that deliver.
using CalibrationFits = std::function<bool(const PerSide<CameraStatus>&)>;

class Measuring {
 public:
  /// @param model  null = no calibration: cameras run, nothing is measured
  Measuring(MeasuringLinks links, std::shared_ptr<const LineModel> model, CalibrationFits calibration_fits,
            UnitReport report);

  /// Runs until stop is requested, noticed within 20 ms; the last thing it publishes is that the unit has stopped.
  void run(const std::stop_token& stop);

  /// What run does with each event: a verdict is published, and without one what has become of the cameras.
  void step(const Event& event);

 private:
  void publish(const PerSide<CameraStatus>& cameras, TimePoint now);
  /// Swaps the model when the judgement of the calibration has changed.
  bool check_cameras(const PerSide<CameraStatus>& cameras);

  MeasuringLinks links_;
  std::shared_ptr<const LineModel> model_;
  CalibrationFits calibration_fits_;
  UnitReport report_;
  CameraLog log_;
  Line line_;
  TimePoint published_{};
};

}  // namespace tripoint
