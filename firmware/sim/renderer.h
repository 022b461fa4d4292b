// One frame as a camera of the simulated world takes it, and the truth that went into it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ports/frame.h"
#include "sim/developing.h"
#include "sim/sensor.h"
#include "sim/spot.h"
#include "sim/tag_painter.h"
#include "sim/world.h"

namespace tripoint {

/// One light source in one picture, at the middle of the exposure of the very row in which it appears.
struct LightTruth {
  int id = 0;
  RawPixel at;
  Duration exposed_since_1970{0};
  Vec3 in_reference_mm = Vec3::Zero();
  double core_sigma_px = 0.0;
  double peak = 0.0;           ///< of the core in this picture, times clip
  bool visible = false;        ///< in front of the camera and inside the picture; otherwise `at` may be anything
  double lit_share = 1.0;      ///< of the exposure; 0 when it was out
  double visible_share = 1.0;  ///< of the core's light: the rest is hidden by nearer figures or falls beside the mirror
};

struct FrameTruth {
  Side side = Side::kLeft;
  Duration exposed_since_1970{0};  ///< middle of the exposure of row 0
  TimePoint exposed{};             ///< the same on the monotonic clock; offline both clocks are one
  TimePoint stamp{};               ///< what the camera says instead; offline the truth
  Isometry3 reference_from_target = Isometry3::Identity();  ///< at the exposure of row 0
  std::vector<LightTruth> lights;                           ///< in the scene's order
  std::vector<TagTruth> tags;                               ///< likewise
};

struct RenderedFrame {
  PixelFormat format = PixelFormat::kYuyv;
  ImageSize size;
  std::size_t stride_bytes = 0;  ///< of a row; 0 for MJPEG
  Duration line_time{0};
  std::vector<std::uint8_t> pixels;
  FrameTruth truth;
};

/// Renders frames of one camera; keeps its buffers between frames. The world must outlive it.
class FrameRenderer {
 public:
  FrameRenderer(const SimulatedWorld& world, Side side);

  /// The frame whose row 0 has its middle of exposure at this time. Its noise depends on the world's seed, the side
  /// and `number` alone, so that the same call gives the same bytes.
  const RenderedFrame& render(Duration exposed_since_1970, std::uint64_t number);

  /// Mean light under the mosaic of the frame last rendered, before noise, conversion and clipping.
  [[nodiscard]] const LightPlane& light() const { return light_; }
  [[nodiscard]] const RawPlane& raw() const { return raw_; }

 private:
  struct Sight {
    RawPixel at;
    double depth_mm;
    Vec3 in_reference_mm;  ///< of a light in a mirror: where it seems to be
  };
  /// A part of a light's picture.
  struct Gaussian {
    double sigma_px = 1.0;
    double elongation = 1.0;
    double energy = 0.0;  ///< in a channel of relative colour 1
    std::span<const Mask> masks = {};
  };
  [[nodiscard]] double lit_share(const LightSource& light, Duration from_1970, Duration to_1970) const;
  [[nodiscard]] std::optional<Sight> sight_of(const LightSource& light, Duration since_1970) const;
  [[nodiscard]] std::optional<Sight> sight_by_row(const LightSource& light, LightTruth& truth) const;
  [[nodiscard]] std::vector<Mask> masks_before(const LightSource& light, const LightTruth& truth) const;
  LightTruth add_light(const LightSource& light, Duration exposed_since_1970);
  void add_gaussian(const LightSource& light, const LightTruth& truth, const Gaussian& part);
  void expose(std::uint64_t number);
  void encode();

  const SimulatedWorld& world_;
  Side side_;
  TagPainter tags_;
  LightPlane light_;
  RawPlane raw_;
  Developer developer_;
  YuyvPacker packer_;
  RenderedFrame frame_;
};

/// One frame by itself, for tests and offline rendering.
RenderedFrame render(const SimulatedWorld& world, Side side, Duration exposed_since_1970, std::uint64_t number = 0);

/// A rendered frame as a camera hands it out, except for its number; it views `rendered`.
Frame frame_of(const RenderedFrame& rendered);

}  // namespace tripoint
