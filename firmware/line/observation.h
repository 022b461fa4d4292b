// What a camera's thread tells the line: image points, or that the camera has gone or come back.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// Identity that a picture itself can show: an AprilTag's id and corner. LEDs have none.
struct PointLabel {
  int tag_id = 0;
  int corner = 0;
  friend bool operator==(const PointLabel&, const PointLabel&) = default;
};

struct ImagePoint {
  RawPixel at;
  Matrix2 covariance_px2 = Matrix2::Identity();
  std::optional<PointLabel> label;
  /// With the next corner of the same tag, this one in the rows: they share an edge and its error.
  Matrix2 shared_with_next_px2 = Matrix2::Zero();
  double amplitude = 0.0;  ///< luma steps above the background
  double sigma_px = 0.0;   ///< fitted size of the spot
  double peak = 0.0;       ///< largest luma value
  bool saturated = false;  ///< all three channels clip; a clipped red channel alone is the recommended exposure
  bool weak = false;
  std::uint16_t led = 0;  ///< id of the target's point that its blinking shows; 0 = not known
  int reach_px = 0;       ///< rows above and below that had a say; regions of the next pictures must hold them
};

enum class Coverage : std::uint8_t { kWholeFrame, kRegions };

/// Of a camera's numbers, at least every so manieth is a picture seen whole; regions further from one are not believed.
inline constexpr std::uint32_t kFramesPerWhole = 5;

/// What the picture as a whole shows, for registers and diagnosis.
struct ImageHealth {
  double mean_luma = 0.0;       ///< of a sparse sample of the last picture seen whole
  double peak_luma = 0.0;       ///< of the brightest spot
  double dimmest_luma = 0.0;    ///< the same of the dimmest spot; both are 0 without any
  double focus = 0.0;           ///< 1 / fitted sigma of the sharpest spot, 1/px
  bool candidates_cut = false;  ///< more candidates than the cap: not everything was looked at
  bool identical = false;       ///< bit-identical to an earlier picture: the camera repeats itself
};

struct Observation {
  Side side = Side::kLeft;
  std::uint32_t frame = 0;  ///< the driver's sequence number
  TimePoint exposed{};      ///< middle of the exposure of row 0, as stamped
  TimePoint arrived{};
  Duration line_time{0};             ///< row r was exposed r times this later
  std::optional<Duration> exposure;  ///< how long each row was exposed; absent = the camera does not say
  std::uint64_t forecast_used = 0;   ///< number of the forecast, 0 = none
  Coverage coverage = Coverage::kWholeFrame;
  bool leds_out = false;       ///< not all LEDs were lit: a sign of life and a stamp, and nothing to be seen
  std::uint32_t left_out = 0;  ///< so many such pictures came right before
  FixedVector<ImagePoint, kMaxImagePoints> points;
  ImageHealth health;
};

struct CameraLost {
  Side side = Side::kLeft;
  TimePoint at{};
};
struct CameraBack {
  Side side = Side::kLeft;
  TimePoint at{};
};
/// Time passes without pictures: lets the line notice silence.
struct Tick {
  TimePoint at{};
};

using Event = std::variant<Observation, CameraLost, CameraBack, Tick>;

}  // namespace tripoint
