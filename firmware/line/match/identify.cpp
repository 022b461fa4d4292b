#include "line/match/identify.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/rigid_fit.h"

namespace tripoint {
namespace {

constexpr int kMostTries = 100'000;  // far more than twelve spots in a plane of epipolar lines need
constexpr int kMostJudged = 300;     // orders whose chi-square is found: more than 100 are seen with coarse spots alone
constexpr std::size_t kMostAway = 32;
constexpr int kSteps = 3;  // of the rigid motion, from a frame that three of the points give

// Upper 1e-3 quantiles of chi-square with 4 n - 6 degrees of freedom, n = 3 to 12.
constexpr std::array<double, 10> kMostChi2{22.458, 29.588, 36.123, 42.312, 48.268,
                                           54.052, 59.703, 65.247, 70.703, 76.084};

using Stack = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4 * kMaxTargetPoints, 1>;
using StackMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4 * kMaxTargetPoints, 4 * kMaxTargetPoints>;
using StackBySix = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 4 * kMaxTargetPoints, 6>;
using StackByCalibration = Eigen::Matrix<double, Eigen::Dynamic, 24, 0, 4 * kMaxTargetPoints, 24>;

double sigma_of(const TargetPoint& point) { return point.uncertainty_mm / 2.0; }

class Search {
 public:
  Search(std::span<const PlacedPair> pairs, const LineModel& model)
      : pairs_(pairs),
        model_(model),
        points_(model.target.points),
        most_chi2_(kMostChi2[points_.size() - 3]),
        length_sigmas_(std::sqrt(most_chi2_ + kRunnerUpWorse)) {
    for (const PlacedPair& pair : pairs) {
      shared_mm2_.push_back(pair.place_by_calibration * model.covariance * pair.place_by_calibration.transpose());
    }
    order_points();
  }

  Identification result() {
    if (pairs_.size() >= points_.size()) try_point(0);
    if (given_up()) return {IdentityVerdict::kAmbiguous, {}};
    if (best_.chi2 > most_chi2_) {
      const auto fits = [&](const Identity& away) { return away.chi2 <= most_chi2_; };
      const bool faces_away = std::any_of(away_.begin(), away_.end(), fits);
      return {faces_away ? IdentityVerdict::kFacesAway : IdentityVerdict::kNone, {}};
    }
    if (second_chi2_ - best_.chi2 < kRunnerUpWorse) return {IdentityVerdict::kAmbiguous, {}};
    // The best may be an image in a mirror in a wrong order. Another image, beside the target, does no harm.
    const auto rivals = [&](const Identity& away) {
      return away.chi2 - best_.chi2 < kRunnerUpWorse && share_a_spot(away, best_);
    };
    if (std::any_of(away_.begin(), away_.end(), rivals)) return {IdentityVerdict::kAmbiguous, {}};
    const auto believed = [&](std::size_t pair) { return pairs_[pair].alike; };
    if (!std::all_of(best_.pair_of_point.begin(), best_.pair_of_point.end(), believed)) {
      return {IdentityVerdict::kNone, {}};
    }
    return {IdentityVerdict::kUnique, best_};
  }

 private:
  /// The widest triangle first: it says best how the target is turned.
  void order_points() {
    FixedVector<Vec3, kMaxTargetPoints> places_mm;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      order_.push_back(i);
      places_mm.push_back(points_[i].in_target_mm);
    }
    const std::array<std::size_t, 3> first = widest_triangle({places_mm.begin(), places_mm.size()});
    for (std::size_t k = 0; k < 3; ++k) std::swap(order_[k], order_[index_in_order(first[k])]);
  }
  [[nodiscard]] std::size_t index_in_order(std::size_t point) const {
    return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), point) - order_.begin());
  }

  [[nodiscard]] bool given_up() const { return tries_ > kMostTries || judged_ > kMostJudged || away_.full(); }

  void try_point(std::size_t depth) {
    if (depth == points_.size()) return judge();
    for (std::size_t pair = 0; pair < pairs_.size() && !given_up(); ++pair) {
      ++tries_;
      if (!may_be(depth, pair)) continue;
      chosen_.push_back(pair);
      try_point(depth + 1);
      chosen_.pop_back();
    }
  }

  /// Whether a pair may be the next point, beside those that were chosen.
  [[nodiscard]] bool may_be(std::size_t depth, std::size_t pair) const {
    const std::uint16_t led = pairs_[pair].led;
    if (led != 0 && led != points_[order_[depth]].id) return false;
    for (std::size_t k = 0; k < depth; ++k) {
      const PlacedPair& other = pairs_[chosen_[k]];
      if (other.index.left == pairs_[pair].index.left || other.index.right == pairs_[pair].index.right) return false;
      if (!length_fits(order_[depth], order_[k], pair, chosen_[k])) return false;
    }
    return true;
  }

  [[nodiscard]] bool length_fits(std::size_t point_a, std::size_t point_b, std::size_t a, std::size_t b) const {
    const Vec3 apart_mm = pairs_[a].in_rig_mm - pairs_[b].in_rig_mm;
    const double length_mm = apart_mm.norm();
    if (!(length_mm > 0.0)) return false;
    const Vec3 along = apart_mm / length_mm;
    // Of a difference the calibration's part is at most twice the sum of both, however they go together.
    const Matrix3 spread =
        pairs_[a].covariance_mm2 + pairs_[b].covariance_mm2 + 2.0 * (shared_mm2_[a] + shared_mm2_[b]);
    const double target = std::hypot(sigma_of(points_[point_a]), sigma_of(points_[point_b]));
    const double sigma_mm = std::sqrt(along.dot(spread * along) + target * target);
    const double expected_mm = (points_[point_a].in_target_mm - points_[point_b].in_target_mm).norm();
    return std::abs(length_mm - expected_mm) <= length_sigmas_ * sigma_mm;
  }

  void judge() {
    ++judged_;
    Identity identity;
    for (std::size_t i = 0; i < points_.size(); ++i) identity.pair_of_point.push_back(chosen_[index_in_order(i)]);
    Isometry3 pose = start(identity);
    identity.chi2 = chi2(identity, pose);
    if (!std::isfinite(identity.chi2)) return;
    if (!shines_into_both(pose)) {
      if (identity.chi2 <= most_chi2_ + kRunnerUpWorse) away_.push_back(identity);
      return;
    }
    if (identity.chi2 < best_.chi2) {
      second_chi2_ = best_.chi2;
      best_ = identity;
    } else {
      second_chi2_ = std::min(second_chi2_, identity.chi2);
    }
  }

  [[nodiscard]] bool share_a_spot(const Identity& a, const Identity& b) const {
    return std::any_of(a.pair_of_point.begin(), a.pair_of_point.end(), [&](std::size_t i) {
      return std::any_of(b.pair_of_point.begin(), b.pair_of_point.end(), [&](std::size_t j) {
        return pairs_[i].index.left == pairs_[j].index.left || pairs_[i].index.right == pairs_[j].index.right;
      });
    });
  }

  [[nodiscard]] Isometry3 start(const Identity& identity) const {
    const auto seen = [&](std::size_t k) { return pairs_[identity.pair_of_point[order_[k]]].in_rig_mm; };
    const auto made = [&](std::size_t k) { return points_[order_[k]].in_target_mm; };
    return three_point_frame(seen(0), seen(1), seen(2)) * three_point_frame(made(0), made(1), made(2)).inverse();
  }

  /// Covariance of all places and epipolar distances: three rows for each place, then one for each distance.
  [[nodiscard]] StackMatrix covariance(const Identity& identity) const {
    const auto count = static_cast<Eigen::Index>(points_.size());
    StackMatrix whole = StackMatrix::Zero(4 * count, 4 * count);
    if (!model_.covariance.isZero(0.0)) add_calibration(whole, identity);
    for (Eigen::Index i = 0; i < count; ++i) {
      const PlacedPair& pair = pairs_[identity.pair_of_point[static_cast<std::size_t>(i)]];
      const double sigma_mm = sigma_of(points_[static_cast<std::size_t>(i)]);
      whole.block<3, 3>(3 * i, 3 * i) += pair.covariance_mm2 + sigma_mm * sigma_mm * Matrix3::Identity();
      whole(3 * count + i, 3 * count + i) += pair.epipolar_variance_px2;
    }
    return whole;
  }

  void add_calibration(StackMatrix& whole, const Identity& identity) const {
    const auto count = static_cast<Eigen::Index>(points_.size());
    StackByCalibration by_calibration(4 * count, 24);
    for (Eigen::Index i = 0; i < count; ++i) {
      const PlacedPair& pair = pairs_[identity.pair_of_point[static_cast<std::size_t>(i)]];
      by_calibration.middleRows<3>(3 * i) = pair.place_by_calibration;
      by_calibration.row(3 * count + i) = pair.epipolar_by_calibration.transpose();
    }
    const StackByCalibration spread = by_calibration.lazyProduct(model_.covariance);
    whole += spread.lazyProduct(by_calibration.transpose());
  }

  /// Least chi-square over all poses, from one nearby, which becomes the best; infinite when there is none.
  double chi2(const Identity& identity, Isometry3& pose) const {
    const auto count = static_cast<Eigen::Index>(points_.size());
    StackMatrix root = covariance(identity);
    const Eigen::LLT<Eigen::Ref<StackMatrix>> factor(root);
    if (factor.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
    double best = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kSteps; ++step) {
      Stack residual(4 * count);
      StackBySix slope = StackBySix::Zero(4 * count, 6);
      for (Eigen::Index i = 0; i < count; ++i) {
        const PlacedPair& pair = pairs_[identity.pair_of_point[static_cast<std::size_t>(i)]];
        const Vec3 arm_mm = pose.linear() * points_[static_cast<std::size_t>(i)].in_target_mm;
        residual.segment<3>(3 * i) = pair.in_rig_mm - pose.translation() - arm_mm;
        residual(3 * count + i) = pair.epipolar_px;
        slope.block<3, 3>(3 * i, 0).setIdentity();
        slope.block<3, 3>(3 * i, 3) = -cross_matrix(arm_mm);
      }
      factor.matrixL().solveInPlace(residual);
      factor.matrixL().solveInPlace(slope);
      const Matrix6 information = slope.transpose().lazyProduct(slope);
      const PoseParameters gradient = slope.transpose().lazyProduct(residual);
      const PoseParameters move = Eigen::LLT<Matrix6>(information).solve(gradient);
      best = residual.squaredNorm() - gradient.dot(move);
      pose = moved(pose, move);
    }
    return best;
  }

  /// Every LED into both lenses.
  [[nodiscard]] bool shines_into_both(const Isometry3& rig_from_target) const {
    return std::all_of(points_.begin(), points_.end(), [&](const TargetPoint& point) {
      const Vec3 shines = rig_from_target.linear() * point.facing.value_or(model_.target.facing);
      const Vec3 led_mm = rig_from_target * point.in_target_mm;
      return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
        const Vec3 lens_mm = model_.rig.camera_from_rig[side].inverse().translation();
        return shines.dot((lens_mm - led_mm).normalized()) > std::cos(kMostFacing_rad);
      });
    });
  }

  std::span<const PlacedPair> pairs_;
  const LineModel& model_;
  const FixedVector<TargetPoint, kMaxTargetPoints>& points_;
  FixedVector<Matrix3, kMaxPlacedPairs> shared_mm2_;
  FixedVector<std::size_t, kMaxTargetPoints> order_;   // of the target's points, as they are tried
  FixedVector<std::size_t, kMaxTargetPoints> chosen_;  // pairs, in that order
  Identity best_{{}, std::numeric_limits<double>::infinity()};
  double second_chi2_ = std::numeric_limits<double>::infinity();
  FixedVector<Identity, kMostAway> away_;  // those that shine away, as far as they may stand beside the best
  double most_chi2_;
  double length_sigmas_;  // a rival that would make the best ambiguous is still tried
  int tries_ = 0;
  int judged_ = 0;
};

}  // namespace

Identification identify(std::span<const PlacedPair> pairs, const LineModel& model) {
  return Search(pairs, model).result();
}

}  // namespace tripoint
