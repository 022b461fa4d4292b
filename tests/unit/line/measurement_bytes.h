// Every value of a measurement as bytes, without the padding between them: equal bytes are equal measurements.
#pragma once

#include <cstring>
#include <string>
#include <type_traits>

#include "line/measurement.h"

namespace tripoint::testing {

class Bytes {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T> Bytes& operator<<(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    text_.append(raw, sizeof(T));
    return *this;
  }
  template <typename Derived>
  Bytes& operator<<(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) *this << static_cast<double>(matrix(i, j));
    }
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

inline std::string bytes_of(const Measurement& m) {
  Bytes bytes;
  bytes << m.sequence << ns_from_time(m.exposed) << ns_from_time(m.exposure_began) << m.common_time << m.faults.bits()
        << m.warnings.bits();
  bytes << m.timing.skew_s << m.timing.skew_sigma_s << m.timing.uncorrected_cost_mm.value_or(-1.0)
        << m.timing.speed_mm_per_s << m.timing.settled << m.points.size();
  for (const MeasuredPoint& point : m.points) {
    bytes << point.id << point.in_output_mm << point.covariance_mm2 << point.residual_px << point.at.left.u_px
          << point.at.left.v_px << point.at.right.u_px << point.at.right.v_px << point.peak_luma.left
          << point.peak_luma.right << point.saturated << point.weak;
  }
  bytes << m.pose.has_value();
  if (m.pose) {
    bytes << m.pose->position_in_output_mm << m.pose->output_from_target.has_value() << m.pose->noise << m.pose->shared;
  }
  bytes << m.side_length_error_mm.value_or(0.0) << m.decalibration_mm.value_or(0.0);
  bytes << m.residual_rms_px << m.epipolar_rms_px << m.spots.left << m.spots.right;
  for (const Side side : kBothSides) {
    const ImageHealth& health = m.health[side];
    bytes << health.mean_luma << health.peak_luma << health.dimmest_luma << health.focus << health.candidates_cut
          << health.identical;
  }
  return bytes.text();
}

}  // namespace tripoint::testing
