// The sensor: light to digital counts under a Bayer mosaic, with shot noise, read noise and clipping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "values/pixel.h"

namespace tripoint {

/// Linear. Levels are in units of clip.
struct SensorModel {
  double read_noise = 0.002;            ///< standard deviation
  double full_well_electrons = 8000.0;  ///< at clip: the variance of the shot noise is level / full well
  double optical_sigma_px = 0.8;        ///< standard deviation of the lens's blur
  double hot_pixel_share = 0.0;         ///< of all pixels
  double hot_pixel_level = 0.5;         ///< what a hot pixel's dark current adds
};

/// The hot pixels of one sensor, as places in its row by row order; the key is its serial number, so to say.
std::vector<std::size_t> hot_pixels(const SensorModel& sensor, ImageSize size, std::uint64_t key);

/// Counts of the converter (10 bit) at clip. A pedestal below zero keeps dark noise symmetric, as in real sensors;
/// it is subtracted again, so that counts may be negative.
inline constexpr int kClipCounts = 1023;
inline constexpr int kPedestalCounts = 64;

/// Colour of a pixel of the mosaic: 0 red, 1 green, 2 blue. Red at even x of even rows.
constexpr std::size_t bayer_channel(int x, int y) {
  return (static_cast<std::size_t>(x) & 1U) + (static_cast<std::size_t>(y) & 1U);
}

/// Normal noise of mean 0 and variance 1, made once; every row of every frame starts at its own place in it.
class NoiseTable {
 public:
  /// @param longest_row the most values that a caller takes at once
  NoiseTable(std::uint64_t seed, std::size_t longest_row);

  /// `longest_row` values; the place is drawn from the key.
  [[nodiscard]] std::span<const float> row(std::uint64_t key) const;

 private:
  static constexpr std::size_t kStarts = std::size_t{1} << 17U;
  std::size_t longest_row_;
  std::vector<float> values_;
};

/// What the converter delivered: one count a pixel, under the mosaic.
class RawPlane {
 public:
  explicit RawPlane(ImageSize size);

  [[nodiscard]] ImageSize size() const { return size_; }

  /// Exposes and converts one row.
  /// @param expected  mean level of each pixel, in units of clip
  /// @param noise     a value of mean 0 and variance 1 for each pixel
  void expose_row(int y, std::span<const float> expected, std::span<const float> noise, const SensorModel& sensor);

  /// Row y from -1 to the height, x from -1 to the width: the rim mirrors the picture, which keeps the mosaic's order.
  [[nodiscard]] const std::int16_t* row(int y) const;

 private:
  static constexpr std::size_t kRim = 8;  ///< more than the one pixel needed: keeps rows aligned
  ImageSize size_;
  std::size_t stride_;
  std::vector<std::int16_t> counts_;
};

}  // namespace tripoint
