// From counts under the mosaic to luma and chroma: bilinear demosaicing, the camera's tone, and BT.601.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/sensor.h"
#include "values/linear.h"
#include "values/pixel.h"

namespace tripoint {

/// Video cameras send YUYV with luma 16 to 235; JPEG uses the whole byte.
enum class YuvRange : std::uint8_t { kVideo, kFull };

/// What a camera does to demosaiced colours before it converts them; the default leaves them linear.
struct Tone {
  Matrix3 color_matrix = Matrix3::Identity();  ///< of red, green, blue; rows that sum to 1 keep white
  double gamma = 1.0;                          ///< output is level^(1/gamma), both 0 to 1
};

/// As webcams deliver it: more saturated colours, and the gamma of a display.
Tone webcam_tone();

/// 8-bit planes; chroma has half the width and belongs to the middle between its two pixels.
struct YuvPlanes {
  ImageSize size;
  std::vector<std::uint8_t> y;
  std::vector<std::uint8_t> u;
  std::vector<std::uint8_t> v;
};

/// Develops pictures of one size; keeps its buffers between pictures.
/// Source of the coefficients: ITU-R BT.601-7, section 2.5.
class Developer {
 public:
  Developer(ImageSize size, YuvRange range, const Tone& tone = {});

  void develop(const RawPlane& raw);
  [[nodiscard]] const YuvPlanes& planes() const { return planes_; }

 private:
  void demosaic_row(const RawPlane& raw, int y);
  void tone_row();
  void convert_row(int y);

  /// Fixed-point coefficients for quarter counts, scaled by 2^kShift; the offset rounds.
  struct Weights {
    std::int32_t red;
    std::int32_t green;
    std::int32_t blue;
    std::int32_t offset;
  };
  static Weights weights(double red, double green, double blue, double offset);

  YuvPlanes planes_;
  Weights luma_{};
  Weights chroma_u_{};
  Weights chroma_v_{};
  Eigen::Matrix3f color_matrix_;
  std::vector<std::int16_t> curve_;   ///< of quarter counts from 0 to clip; empty: linear, with no matrix either
  std::vector<std::int16_t> is_odd_;  ///< all bits set at odd x
  std::vector<std::int16_t> red_;
  std::vector<std::int16_t> green_;
  std::vector<std::int16_t> blue_;
};

/// The bytes Y0 U Y1 V of a YUYV frame.
class YuyvPacker {
 public:
  explicit YuyvPacker(ImageSize size);
  void pack(const YuvPlanes& planes);
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace tripoint
