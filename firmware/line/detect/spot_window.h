// A small part of the picture around one candidate: strength S, luma Y and red V of every pixel.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "ports/frame.h"

namespace tripoint {

/// What is measured of a pixel: Y, or a quarter of S, which is on the same scale.
enum class Channel : std::uint8_t { kLuma, kStrength };

/// Coordinates are window columns and rows; add `left_px` and `top_px` for the picture's.
class SpotWindow {
 public:
  static constexpr int kMaxHalf = 40;
  static constexpr int kStride = 88;  ///< whole groups of 8 pixels for 2 * kMaxHalf + 2
  static constexpr std::size_t kPixels = std::size_t{kStride} * kStride;
  static constexpr std::int16_t kOutside = -1;  ///< strength of a pixel outside the picture

  /// At least `half` pixels to every side of a pixel of the picture; the left column is even.
  void load(const Picture& picture, int center_u, int center_v, int half);

  [[nodiscard]] int left_px() const { return left_px_; }
  [[nodiscard]] int top_px() const { return top_px_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

  /// First and last columns and rows, inclusive.
  struct Part {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
  };
  /// What a window of `half` around that pixel of the picture would show.
  [[nodiscard]] Part around(int center_u, int center_v, int half) const {
    const int left = even(center_u - half) - left_px_;
    const int top = center_v - half - top_px_;
    return {left, top, left + 2 * half + 1, top + 2 * half};
  }
  /// The part that lies in the picture.
  [[nodiscard]] Part in_picture() const {
    return {std::max(0, -left_px_), std::max(0, -top_px_), std::min(columns_, picture_size_.width_px - left_px_) - 1,
            std::min(rows_, picture_size_.height_px - top_px_) - 1};
  }

  [[nodiscard]] static constexpr std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row) * kStride + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool holds(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_;
  }
  [[nodiscard]] int strength(std::size_t i) const { return strength_[i]; }
  [[nodiscard]] int luma(std::size_t i) const { return luma_[i]; }
  [[nodiscard]] int red(std::size_t i) const { return red_[i]; }
  [[nodiscard]] const std::uint8_t* lumas(std::size_t i) const { return luma_.data() + i; }
  [[nodiscard]] const std::int16_t* strengths(std::size_t i) const { return strength_.data() + i; }
  [[nodiscard]] bool outside(std::size_t i) const { return strength_[i] == kOutside; }

 private:
  static constexpr int even(int u_px) { return u_px & ~1; }
  void load_row(const Picture& picture, int row);
  void load_eight(const std::uint8_t* yuyv, std::size_t i);
  template <int kLumaStep, int kRedStep>
  void load_pair(const Picture& picture, std::size_t i, int u_px, int v_px);

  ImageSize picture_size_;
  int left_px_ = 0;
  int top_px_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::array<std::int16_t, kPixels> strength_{};
  std::array<std::uint8_t, kPixels> luma_{};
  std::array<std::uint8_t, kPixels> red_{};
};

}  // namespace tripoint
