// Red LEDs in a picture: a coarse map, the cells that stand alone, and a close look at each.
#pragma once

#include <optional>

#include "line/detect/candidate.h"
#include "line/detect/coarse.h"
#include "line/detect/inspect.h"
#include "line/detect/light.h"
#include "line/detect/select.h"
#include "line/detect/settings.h"
#include "line/observation.h"
#include "ports/frame.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"

namespace tripoint {

/// What one picture shows; capture adds side, time and number to make an Observation.
struct Detection {
  FixedVector<ImagePoint, kMaxImagePoints> points;
  ImageHealth health;
};

/// Allocates when the size of the pictures changes, otherwise never.
class LedDetector {
 public:
  explicit LedDetector(const LedDetectorSettings& settings);

  /// @param picture  must have chroma: a GREY picture is a bug of the caller
  /// The forecast does not steer it: a picture that is in memory is always scanned whole.
  Detection detect(const Picture& picture, const Forecast& forecast);

  /// Everything the last `detect` looked at, kept or dropped, with the cause.
  [[nodiscard]] const CandidateLog& candidates() const { return log_; }

 private:
  void look(const Picture& picture, PixelPlace start);
  [[nodiscard]] bool covered(PixelPlace start) const;
  void keep(const Picture& picture, const Inspection& inspection);
  DropCause make_room(const Candidate& candidate, const ImagePoint& point);
  [[nodiscard]] DropCause judge_light(const Picture& picture, Candidate& candidate) const;

  LedDetectorSettings settings_;
  CoarseMap map_;
  Inspector inspector_;
  CandidateLog log_;
  Detection detection_;
  SceneLight light_;
};

}  // namespace tripoint
