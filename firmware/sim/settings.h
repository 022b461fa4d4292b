// What can be chosen about the simulation: motion, scene, cameras, clocks, and what goes wrong when.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/rig.h"
#include "ports/camera.h"
#include "ports/frame.h"
#include "sim/default_rig.h"
#include "sim/developing.h"
#include "sim/jpeg_encoder.h"
#include "sim/scene.h"
#include "sim/sensor.h"
#include "sim/trajectory.h"
#include "values/linear.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// How one camera's own clock runs, and how well the driver's stamps follow it.
struct CameraClock {
  Duration phase{0};          ///< of frame 0 after the world's start
  double drift_ppm = 0.0;     ///< positive: its frames come too slowly
  Duration stamp_jitter{0};   ///< standard deviation, normal, cut at 4 of them
  Duration stamp_latency{0};  ///< by which every stamp is late
};

enum class Trouble : std::uint8_t {
  kVanish,   ///< unplugged: the open camera is lost for good, and none can be opened
  kHang,     ///< no frames, no error
  kRepeat,   ///< the same picture again and again, with fresh stamps
  kCorrupt,  ///< MJPEG cut off in the middle; other formats arrive as kCorruptFrame
};

/// One thing that goes wrong, from and to a time after the world's start.
struct PlannedTrouble {
  Side side = Side::kLeft;
  Trouble trouble = Trouble::kVanish;
  Duration from{0};
  Duration to{0};
};

/// A camera that stands turned about its own lens for a part of each period of the trajectory. Lights show it, surfaces
/// stay where they were.
struct Knock {
  Side side = Side::kRight;
  Vec3 turn_rad = Vec3::Zero();  ///< rotation vector along the camera's axes
  Duration from{0};              ///< phase of the trajectory
  Duration to{0};
};
/// What "bumped-camera" does: the right camera turns by 0.1 degrees about the vertical in the second of three rounds.
Knock bumped_camera();

inline constexpr GainRange kSimulatedGains{0, 255, 1};  ///< as common webcams have them

/// Share of the time from one moment since 1970 to another in which the light of a line was lit, 0 to 1; when both are
/// one moment, 0 or 1. Asked only about times that are over.
using LitShare = std::function<double(std::size_t line, Duration from_1970, Duration to_1970)>;

struct SimulationSettings {
  Trajectory trajectory = paper_circular();
  Scene scene = led_scene({Vec3::Zero()});
  StereoCalibration rig = default_rig();  ///< the truth; its sizes are the pictures' sizes
  SensorModel sensor;
  Tone tone;
  PixelFormat format = PixelFormat::kYuyv;
  ChromaSampling mjpeg_sampling = ChromaSampling::k422;
  int mjpeg_quality = 90;
  double rate_hz = 30.0;
  Duration exposure{std::chrono::milliseconds{5}};
  int gain = 0;  ///< only told, as kSimulatedGains permits: scene and sensor are given as they are with it
  Duration line_time{std::chrono::microseconds{30}};  ///< row r is exposed r times this later
  PerSide<CameraClock> clocks;
  std::vector<PlannedTrouble> troubles;
  std::optional<Knock> knock;
  LitShare lit_share;  ///< empty: what could be switched is always lit
  std::uint64_t seed = 1;
};

}  // namespace tripoint
