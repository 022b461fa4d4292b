#include "tags/luma_view.h"

#include "values/assert.h"

namespace tripoint {

LumaView luma_of(const Picture& picture) {
  TRIPOINT_ASSERT(picture.bands.empty());
  return {picture.luma, picture.size};
}

/// With a margin for the rounding to float.
bool LumaView::holds(const Vec2& place_px) const {
  constexpr double kRounding_px = 1e-3;
  return place_px.x() >= 0.0 && place_px.y() >= 0.0 && place_px.x() < size.width_px - 1 - kRounding_px &&
         place_px.y() < size.height_px - 1 - kRounding_px;
}

float LumaView::between(float u_px, float v_px) const {
  const int left = static_cast<int>(u_px);
  const int top = static_cast<int>(v_px);
  const float right_share = u_px - static_cast<float>(left);
  const float lower_share = v_px - static_cast<float>(top);
  const std::uint8_t* upper = plane.row(top) + static_cast<std::size_t>(left) * plane.step_bytes;
  const std::uint8_t* lower = upper + plane.stride_bytes;
  const auto of = [&](const std::uint8_t* row) {
    const auto here = static_cast<float>(row[0]);
    return here + right_share * (static_cast<float>(row[plane.step_bytes]) - here);
  };
  const float above = of(upper);
  return above + lower_share * (of(lower) - above);
}

std::optional<float> LumaView::at(const Vec2& place_px) const {
  if (!holds(place_px)) return std::nullopt;
  return between(static_cast<float>(place_px.x()), static_cast<float>(place_px.y()));
}

std::optional<LumaProfile> LumaView::along(const Vec2& from_px, const Vec2& to_px, std::size_t count) const {
  if (!holds(from_px) || !holds(to_px)) return std::nullopt;
  const Eigen::Vector2f from = from_px.cast<float>();
  const Eigen::Vector2f step = ((to_px - from_px) / static_cast<double>(count - 1)).cast<float>();
  LumaProfile profile;
  for (std::size_t i = 0; i < count; ++i) {
    const auto steps = static_cast<float>(i);
    profile.push_back(between(from.x() + steps * step.x(), from.y() + steps * step.y()));
  }
  return profile;
}

}  // namespace tripoint
