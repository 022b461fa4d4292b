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

  /// What is in memory is always scanned, whatever the forecast. Of a picture in bands, a spot is found as in the whole
  /// picture or not at all: it counts only when every row that had a say was decoded. The coarse map and the light of
  /// the scene keep what the last whole picture showed.
  ///
  /// @param picture  must have chroma: a GREY picture is a bug of the caller; its bands are of a picture whose
  ///                 predecessor of the same size was seen whole
  Detection detect(const Picture& picture, const Forecast& forecast);

  /// Everything the last `detect` looked at, kept or dropped, with the cause.
  [[nodiscard]] const CandidateLog& candidates() const { return log_; }

 private:
  [[nodiscard]] bool within_bands(const RowBand& rows) const;
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
  SceneLight light_;   // of the last whole picture
  RowBands bands_;     // of the picture at hand
  int height_px_ = 0;  // of it
};

}  // namespace tripoint
