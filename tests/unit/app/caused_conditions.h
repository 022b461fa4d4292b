// What raises the bits of registers 34 and 35, staged before a unit that measures.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <string_view>
#include <vector>

#include "../line/synthetic_cameras.h"
#include "app/measuring.h"
#include "app/unit_setup.h"
#include "serve/image.h"

namespace tripoint::test {

inline constexpr double kBegins_s = 5.0;  // pictures are exposed from 1 s on
inline constexpr double kEnds_s = 9.0;
inline constexpr double kOver_s = 20.0;  // a warning stays 10 s

/// What differs from kBegins_s to kEnds_s.
struct Cause {
  std::string_view bit;  ///< as the map names it
  std::function<void(Observation&)> picture = [](Observation& /*seen*/) {};
  std::function<bool(const Observation&)> arrives = [](const Observation& /*seen*/) { return true; };
  std::function<void(PerSide<CameraStatus>&)> cameras = [](PerSide<CameraStatus>& /*cameras*/) {};
  bool watched = false;  ///< by a datum
};

inline void PrintTo(const Cause& cause, std::ostream* out) { *out << cause.bit; }

inline const Vec3 kDatum{-80.0, 95.0, 620.0};

inline LineModel model_of(const Cause& cause) {
  LineModel model = testing::webcam_model();
  if (cause.watched) model.datum = Datum{kDatum, 0.2, 10.0};
  return model;
}

inline std::vector<testing::Path> lights_of(const Cause& cause) {
  std::vector<testing::Path> lights{testing::circle(20.0)};
  if (cause.watched) lights.push_back(testing::at_rest(kDatum));
  return lights;
}

inline double exposed_s(const Observation& seen) { return seconds(seen.exposed.time_since_epoch()); }

inline void show(Observation& seen, const LineModel& model, const std::vector<testing::Path>& lights) {
  seen.points.clear();
  for (const testing::Path& light : lights) {
    seen.points.push_back(testing::spot_at(testing::pixel_of(model, seen.side, light, exposed_s(seen), 0.0), 0.05));
  }
}

/// Of one side.
inline std::function<void(Observation&)> picture_of(Side side, const std::function<void(Observation&)>& change) {
  return [=](Observation& seen) {
    if (seen.side == side) change(seen);
  };
}

inline std::function<void(Observation&)> lower_by_px(double offset_px) {
  return picture_of(Side::kRight, [=](Observation& seen) { seen.points[0].at.v_px += offset_px; });
}

inline Cause lost(std::string_view bit, Side side) {
  const auto tell = [=](PerSide<CameraStatus>& cameras) { cameras[side].delivering = false; };
  return {.bit = bit, .arrives = [=](const Observation& seen) { return seen.side != side; }, .cameras = tell};
}

inline Cause dark(std::string_view bit, Side side) {
  return {.bit = bit, .picture = picture_of(side, [](Observation& seen) { seen.points.clear(); })};
}

inline void show_a_lamp_too(Observation& seen) {
  show(seen, testing::webcam_model(), {testing::circle(20.0), testing::at_rest({-20.0, -40.0, 380.0})});
}

inline void show_far_away(Observation& seen) {
  show(seen, testing::webcam_model(), {testing::at_rest({0.0, 0.0, 650.0})});
}

/// By a tenth of a degree, which moves no point far off its epipolar line.
inline void show_knocked(Observation& seen) {
  const LineModel knocked = testing::with_right_camera_turned(testing::webcam_model(), {0.0, 0.1 * M_PI / 180.0, 0.0});
  show(seen, knocked, lights_of({.bit = {}, .watched = true}));
}

inline std::vector<Cause> causes_of_faults() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto poison = [=](Observation& seen) { seen.health.mean_luma = kNone; };
  const auto brighten = [](Observation& seen) { seen.points[0].amplitude *= 4.1; };
  const auto stamp_early = [](Observation& seen) { seen.exposed -= std::chrono::milliseconds(400); };
  const auto replace_left = [](PerSide<CameraStatus>& cameras) { cameras.left.info.serial = "ANOTHER"; };
  return {lost("left_camera_lost", Side::kLeft),
          lost("right_camera_lost", Side::kRight),
          dark("not_seen_left", Side::kLeft),
          dark("not_seen_right", Side::kRight),
          {.bit = "ambiguous", .picture = show_a_lamp_too},
          {.bit = "epipolar_gate", .picture = lower_by_px(0.8)},  // of 0.05 px twice, 4.5 sigma are 0.32 px
          {.bit = "geometry_gate", .picture = picture_of(Side::kLeft, brighten)},
          {.bit = "outside_volume", .picture = show_far_away},
          {.bit = "timing_bound", .picture = picture_of(Side::kLeft, stamp_early)},
          {.bit = "decalibration", .picture = show_knocked, .watched = true},
          {.bit = "calibration_does_not_fit", .cameras = replace_left},
          {.bit = "internal", .picture = picture_of(Side::kLeft, poison)}};
}

inline std::vector<Cause> causes_of_warnings() {
  const auto every_other = [](const Observation& seen) { return seen.side == Side::kLeft || seen.frame % 2 == 0; };
  return {{.bit = "saturated_spot", .picture = [](Observation& seen) { seen.points[0].saturated = true; }},
          {.bit = "weak_spot", .picture = [](Observation& seen) { seen.points[0].weak = true; }},
          {.bit = "high_residual", .picture = lower_by_px(0.28)},  // 4.0 sigma; the warning begins at 3.3
          {.bit = "frames_dropped", .arrives = every_other}};
}

class SetClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  [[nodiscard]] Duration utc_offset() const override { return std::chrono::hours(1); }
  [[nodiscard]] bool synchronised() const override { return true; }
  void set(TimePoint now) { now_ = now; }

 private:
  TimePoint now_{};
};

inline Calibration calibration_of(const LineModel& model) {
  Calibration calibration;
  calibration.stereo = model.calibration;
  calibration.serial = {"LEFT", "RIGHT"};
  return calibration;
}

inline UnitConstants calibrated() {
  UnitConstants constants;
  constants.calibrated = true;
  return constants;
}

/// A unit that measures, with both cameras at 30 Hz.
class Unit {
 public:
  explicit Unit(const Cause& cause) : cause_(cause), model_(model_of(cause)) {}

  /// One picture of each side, and what the registers say after it.
  RegisterImage next() {
    const double at_s = next_s();
    const bool caused = at_s >= kBegins_s && at_s < kEnds_s;
    for (const Side side : kBothSides) {
      cameras_[side].put(status(side, caused));
      Observation seen = testing::picture(side, frame_, at_s);
      clock_.set(seen.arrived);
      show(seen, model_, lights_of(cause_));
      if (caused) cause_.picture(seen);
      if (!caused || cause_.arrives(seen)) measuring_.step(seen);
    }
    ++frame_;
    return image_at(publication_.newest(clock_.now()), ServiceState{}, clock_.now());
  }

  /// When the next pictures are exposed.
  [[nodiscard]] double next_s() const { return 1.0 + frame_ / 30.0; }

 private:
  [[nodiscard]] CameraStatus status(Side side, bool caused) const {
    PerSide<CameraStatus> cameras;
    for (const Side each : kBothSides) {
      cameras[each].delivering = true;
      cameras[each].losses = 1;  // has been away before
      cameras[each].info.serial = calibration_of(model_).serial[each];
      cameras[each].info.size = model_.calibration.cameras[each].size;
    }
    if (caused) cause_.cameras(cameras);
    return cameras[side];
  }

  Cause cause_;
  LineModel model_;
  std::uint32_t frame_ = 0;
  SetClock clock_;
  BoundedQueue<Event> events_{1};
  PerSide<Latest<CameraStatus>> cameras_;
  Latest<Forecast> forecast_;
  Publication publication_{UnitState{}};
  Measuring measuring_{{events_, cameras_, forecast_, publication_, clock_},
                       testing::shared_model(model_),
                       fits_calibration(calibration_of(model_), CameraSource::kV4l2),
                       UnitReport(calibrated(), TimePoint{})};
};

}  // namespace tripoint::test
