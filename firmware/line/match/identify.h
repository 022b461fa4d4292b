// Which of several pairs is which LED of the target: told by geometry alone, because LEDs look alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "geometry/rig.h"
#include "line/model.h"
#include "values/fixed_vector.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

inline constexpr std::size_t kMaxPlacedPairs = 144;  ///< each of 12 spots with each of 12

/// Two image points that may be one point in space, and where it would lie.
struct PlacedPair {
  PerSide<std::size_t> index{0, 0};  ///< of the image points
  bool alike = true;                 ///< of one size and brightness; others are not believed, but may be the true ones
  std::uint16_t led = 0;             ///< id of the target's point that its blinking shows; 0 = not known
  Vec3 in_rig_mm = Vec3::Zero();
  Matrix3 covariance_mm2 = Matrix3::Zero();  ///< of the image points alone, as the next but one
  double epipolar_px = 0.0;
  double epipolar_variance_px2 = 1.0;
  Eigen::Matrix<double, 3, 24> place_by_calibration = Eigen::Matrix<double, 3, 24>::Zero();
  RigParameters epipolar_by_calibration = RigParameters::Zero();
};

/// An order of pairs that may be the target, and how well it fits.
struct Identity {
  FixedVector<std::size_t, kMaxTargetPoints> pair_of_point;  ///< of each point of the target, in its order
  double chi2 = 0.0;                                         ///< 4 n - 6 degrees of freedom
};

enum class IdentityVerdict : std::uint8_t {
  kUnique,
  kNone,       ///< no order of the pairs is the target
  kFacesAway,  ///< one is, but its LEDs would shine away from a camera: it is a mirror image
  kAmbiguous,  ///< another order is not kRunnerUpWorse worse, or there are too many to be tried
};

struct Identification {
  IdentityVerdict verdict = IdentityVerdict::kNone;
  Identity best;  ///< only with kUnique
};

/// Chi-square by which the second best must be worse.
inline constexpr double kRunnerUpWorse = 10.0;
/// A target that is turned further from a camera than this does not shine into it.
inline constexpr double kMostFacing_rad = 85.0 / 180.0 * std::numbers::pi;

/// Tries every order of the pairs as the target's points, all of them seen: first by the distances between them, then
/// by chi-square of the best rigid motion with the full covariance of image points, target and calibration together.
/// Accepted is the best when its chi-square is likelier than 1 in 1,000 and no other comes near; there is no guess,
/// and no memory of earlier pictures.
///
/// @param target three to twelve points of a shape that `shape_fault` does not refuse
Identification identify(std::span<const PlacedPair> pairs, const LineModel& model);

}  // namespace tripoint
