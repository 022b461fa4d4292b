// States for the tests of serve: made from plain numbers, so that a test can say what it expects.
#pragma once

#include <chrono>
#include <cstdint>

#include "serve/publication.h"
#include "serve/register_image.h"
#include "serve/unit_state.h"

namespace tripoint::test {

using std::chrono::milliseconds;

inline constexpr TimePoint kExposed = time_from_ns(5'000'000'000);
inline constexpr Duration kUtcOffset{1'700'000'000'000'000'000};

/// A measurement at kExposed with a position of (-18.67, -50.25, 457.22) mm and standard deviations 0.01, 0.02, 0.1 mm.
inline Measurement position_measurement(std::uint64_t sequence = 70000) {
  Measurement measurement;
  measurement.sequence = sequence;
  measurement.exposed = kExposed;
  measurement.exposure_began = kExposed - milliseconds(33);
  measurement.common_time = true;
  measurement.residual_rms_px = 0.043;
  measurement.epipolar_rms_px = 0.052;
  TargetPose pose;
  pose.position_in_output_mm = Vec3(-18.67, -50.25, 457.22);
  pose.noise.diagonal() << 1e-4 / 2, 4e-4 / 2, 1e-2 / 2, 0.0, 0.0, 0.0;
  pose.shared.diagonal() << 1e-4 / 2, 4e-4 / 2, 1e-2 / 2, 0.0, 0.0, 0.0;
  measurement.pose = pose;
  MeasuredPoint point;
  point.id = 1;
  point.in_output_mm = pose.position_in_output_mm;
  point.covariance_mm2.diagonal() << 1e-4, 4e-4, 1e-2;
  point.residual_px = 0.043;
  measurement.points.push_back(point);
  return measurement;
}

inline UnitState unit_state(const Measurement& measurement = position_measurement()) {
  UnitState state;
  state.identity.serial_number = 0x00C0FFEE;
  state.identity.firmware = {0, 1, 7};
  state.identity.calibration_id = 0x89ABCDEF;
  state.identity.configuration_id = 0x01234567;
  state.identity.setup = 0xBEEF;
  state.flags.ready = state.flags.calibrated = true;
  state.flags.simulated = false;
  state.state = registers::State::kMeasuring;
  state.started = time_from_ns(0);
  state.heartbeat = 41;
  state.newest = PublishedMeasurement{measurement, kUtcOffset};
  state.exposure_since_start = true;
  state.pose_since_start = true;
  return state;
}

inline Edition edition_of(const UnitState& state) {
  return Edition{std::make_shared<const UnitState>(state), Latch{}, {}};
}

inline std::uint64_t bits_at(const RegisterImage& image, std::size_t address, std::size_t words) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < words; ++i) bits = bits << 16U | image[address + i];
  return bits;
}
inline std::int32_t i32_at(const RegisterImage& image, std::size_t address) {
  return static_cast<std::int32_t>(bits_at(image, address, 2));
}
inline std::uint32_t u32_at(const RegisterImage& image, std::size_t address) {
  return static_cast<std::uint32_t>(bits_at(image, address, 2));
}
inline std::int16_t i16_at(const RegisterImage& image, std::size_t address) {
  return static_cast<std::int16_t>(image[address]);
}
inline float f32_at(const RegisterImage& image, std::size_t address) {
  return std::bit_cast<float>(u32_at(image, address));
}

}  // namespace tripoint::test
