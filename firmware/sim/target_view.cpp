#include "sim/target_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

namespace tripoint {
namespace {

constexpr std::uint64_t kOfNoise = 0x9e3779b97f4a7c15;  // so that noise is drawn apart from the scene
constexpr double kMargin_px = 6.0;
constexpr double kLeastToMirror_mm = 5.0;  // an LED has a housing
const Vec3 kFastest_mm_per_s{300.0, 300.0, 300.0};
const Vec3 kFastestTurn_rad_per_s{1.0, 1.0, 1.0};

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}
  double even(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  double normal() { return std::normal_distribution<double>()(engine_); }
  bool happens(double share) { return even(0.0, 1.0) < share; }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }
  Vec3 within(const Vec3& half_mm) {
    return {even(-half_mm.x(), half_mm.x()), even(-half_mm.y(), half_mm.y()), even(-half_mm.z(), half_mm.z())};
  }
  template <typename T>
  void shuffle(std::vector<T>& values) {
    std::shuffle(values.begin(), values.end(), engine_);
  }

 private:
  std::mt19937_64 engine_;
};

using Pixels = PerSide<RawPixel>;

/// Nothing when one of the cameras does not have it in its picture.
std::optional<Pixels> seen_by_both(const Rig& rig, const Vec3& in_rig_mm) {
  Pixels pixels;
  for (const Side side : kBothSides) {
    const Result<RawPixel> at = projected(rig.cameras[side], rig.camera_from_rig[side] * in_rig_mm);
    const ImageSize size = rig.cameras[side].size;
    if (!at || at->u_px < kMargin_px || at->v_px < kMargin_px || at->u_px > size.width_px - 1 - kMargin_px ||
        at->v_px > size.height_px - 1 - kMargin_px) {
      return std::nullopt;
    }
    pixels[side] = *at;
  }
  return pixels;
}

Isometry3 drawn_pose(Draws& draws, const ViewSettings& settings) {
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis);
  };
  return Eigen::Translation3d(settings.middle_mm + draws.within(settings.half_mm)) *
         turn(draws.even(-40.0, 40.0), Vec3::UnitX()) * turn(draws.even(-40.0, 40.0), Vec3::UnitY()) *
         turn(180.0, Vec3::UnitX()) * turn(draws.even(-180.0, 180.0), Vec3::UnitZ());
}

struct Target {
  std::vector<Vec3> leds_mm;
  Vec3 shines = Vec3::UnitZ();
};

Target target_at(const Isometry3& pose, std::span<const Vec3> leds_mm) {
  Target target{{}, pose.linear().col(2)};
  for (const Vec3& led : leds_mm) target.leds_mm.emplace_back(pose * led);
  return target;
}

Isometry3 pose_in_sight(Draws& draws, const Rig& rig, std::span<const Vec3> leds_mm, const ViewSettings& settings) {
  for (;;) {
    const Isometry3 pose = drawn_pose(draws, settings);
    const Target target = target_at(pose, leds_mm);
    const auto in_sight = [&](const Vec3& place) { return seen_by_both(rig, place).has_value(); };
    if (std::all_of(target.leds_mm.begin(), target.leds_mm.end(), in_sight)) return pose;
  }
}

Isometry3 moved_on(const Isometry3& pose, Draws& draws, double for_s) {
  const Vec3 turn_rad = for_s * draws.within(kFastestTurn_rad_per_s);
  Isometry3 moved = pose;
  moved.translation() += for_s * draws.within(kFastest_mm_per_s);
  if (turn_rad.norm() > 0.0) {
    moved.linear() = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()) * pose.linear();
  }
  return moved;
}

Vec3 mirrored(const Vec3& direction, const Vec3& normal) { return direction - 2.0 * normal.dot(direction) * normal; }

class Painter {
 public:
  Painter(const Rig& rig, const ViewSettings& settings, Draws& draws, Draws& noise)
      : rig_(rig), settings_(settings), draws_(draws), noise_(noise) {}

  void add(Side side, const RawPixel& at, int led) {
    view.spots[side].push_back(
        {{at.u_px + settings_.sigma_px * noise_.normal(), at.v_px + settings_.sigma_px * noise_.normal()}, led});
  }
  /// @return false when it is not in both pictures
  bool add(const Vec3& light_mm) {
    const std::optional<Pixels> seen = seen_by_both(rig_, light_mm);
    if (!seen) return false;
    for (const Side side : kBothSides) add(side, (*seen)[side], ViewedSpot::kNoLed);
    return true;
  }
  void add_target(const std::vector<Vec3>& leds_mm) {
    const bool hides = draws_.happens(settings_.hidden_share);
    const std::size_t hidden = draws_.below(leds_mm.size());
    const bool from_left = draws_.happens(0.7);
    const bool from_right = !from_left || draws_.happens(0.5);
    view.whole = !hides;
    for (std::size_t i = 0; i < leds_mm.size(); ++i) {
      const std::optional<Pixels> seen = seen_by_both(rig_, leds_mm[i]);
      view.whole = view.whole && seen;
      if (!seen) continue;  // it has left the pictures
      const bool is_hidden = hides && i == hidden;
      if (!(is_hidden && from_left)) add(Side::kLeft, seen->left, static_cast<int>(i));
      if (!(is_hidden && from_right)) add(Side::kRight, seen->right, static_cast<int>(i));
    }
  }
  /// A mirror near where the target was first, turned any way in which its image then shone into both cameras.
  void add_mirror(const Target& first, const Target& target) {
    for (int tries = 0; tries < 100; ++tries) {
      const Vec3 normal = draws_.within(Vec3::Ones()).normalized();
      const Vec3 mirror = first.leds_mm.front() + draws_.even(30.0, 150.0) * normal;
      const auto image = [&](const Vec3& led) -> Vec3 { return mirror + mirrored(led - mirror, normal); };
      const Vec3 shines = mirrored(first.shines, normal);
      const auto shows = [&](const Vec3& led) {
        return normal.dot(mirror - led) > kLeastToMirror_mm && shines_into_both(image(led), shines);
      };
      if (!std::all_of(first.leds_mm.begin(), first.leds_mm.end(), shows)) continue;
      for (const Vec3& led : target.leds_mm) view.mirrored = add(image(led)) || view.mirrored;
      return;
    }
  }
  void add_others() {
    const auto others = draws_.below(static_cast<std::size_t>(settings_.most_others) + 1);
    const auto has_room = [&](Side side) { return view.spots[side].size() < settings_.most_spots; };
    for (std::size_t i = 0; i < others && has_room(Side::kLeft) && has_room(Side::kRight); ++i) {
      if (draws_.happens(0.5)) {
        add(settings_.middle_mm + draws_.within({150.0, 120.0, 200.0}));
        continue;
      }
      for (const Side side : kBothSides) {
        const ImageSize size = rig_.cameras[side].size;
        add(side, {draws_.even(0.0, size.width_px - 1.0), draws_.even(0.0, size.height_px - 1.0)}, ViewedSpot::kNoLed);
      }
    }
  }

  TargetView view;

 private:
  [[nodiscard]] bool shines_into_both(const Vec3& led_mm, const Vec3& shines) const {
    return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
      return shines.dot(rig_.camera_from_rig[side].inverse().translation() - led_mm) > 0.0;
    });
  }

  const Rig& rig_;
  const ViewSettings& settings_;
  Draws& draws_;  // of the scene
  Draws& noise_;
};

}  // namespace

TargetView target_view(const Rig& rig, std::span<const Vec3> leds_mm, const ViewSettings& settings, std::uint64_t seed,
                       double at_s) {
  Draws draws(seed);
  Draws motion(~seed);
  Draws noise(seed + kOfNoise + static_cast<std::uint64_t>(std::llround(1e9 * at_s)));
  const Isometry3 pose = pose_in_sight(draws, rig, leds_mm, settings);
  const Target first = target_at(pose, leds_mm);
  const Isometry3 pose_now = moved_on(pose, motion, at_s);
  const Target target = target_at(pose_now, leds_mm);
  Painter painter(rig, settings, draws, noise);
  painter.view.rig_from_target = pose_now;
  painter.add_target(target.leds_mm);
  if (draws.happens(settings.mirror_share)) painter.add_mirror(first, target);
  painter.add_others();
  for (const Side side : kBothSides) noise.shuffle(painter.view.spots[side]);
  return painter.view;
}

}  // namespace tripoint
