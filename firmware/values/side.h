// The two cameras, by name; never 0 and 1.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tripoint {

enum class Side : std::uint8_t { kLeft, kRight };

inline constexpr std::array<Side, 2> kBothSides{Side::kLeft, Side::kRight};

constexpr Side other(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
constexpr std::string_view name(Side side) { return side == Side::kLeft ? "left" : "right"; }

/// One value for each camera.
template <typename T>
struct PerSide {
  T left{};
  T right{};

  constexpr T& operator[](Side side) { return side == Side::kLeft ? left : right; }
  constexpr const T& operator[](Side side) const { return side == Side::kLeft ? left : right; }
  friend bool operator==(const PerSide&, const PerSide&) = default;
};

}  // namespace tripoint
