// The luma of a picture where the camera put it, read between pixels.
#pragma once

#include <cstddef>
#include <optional>

#include "ports/frame.h"
#include "values/fixed_vector.h"
#include "values/linear.h"

namespace tripoint {

inline constexpr std::size_t kMostSamples = 20;
using LumaProfile = FixedVector<float, kMostSamples>;

/// Of any pixel format and of all rows; the picture's buffer must outlive it.
struct LumaView {
  Plane plane;
  ImageSize size;

  /// Luma between the four pixels around a place, pixel centres at integers; nothing outside of the picture.
  [[nodiscard]] std::optional<float> at(const Vec2& place_px) const;
  /// The same at evenly spaced places.
  ///
  /// @param count  from 2 to kMostSamples
  /// @return nothing unless all of them are in the picture
  [[nodiscard]] std::optional<LumaProfile> along(const Vec2& from_px, const Vec2& to_px, std::size_t count) const;

 private:
  [[nodiscard]] bool holds(const Vec2& place_px) const;
  [[nodiscard]] float between(float u_px, float v_px) const;
};

/// @param picture  of all rows, not of bands
LumaView luma_of(const Picture& picture);

}  // namespace tripoint
