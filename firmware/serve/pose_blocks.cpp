#include "serve/pose_blocks.h"

#include <array>
#include <numbers>

namespace tripoint {
namespace {

using Optional = std::optional<double>;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Every number of a pose, absent where it is not valid.
struct Numbers {
  std::array<Optional, 3> position_mm;
  std::array<Optional, 3> abc_deg;
  std::array<Optional, 4> quaternion;
  std::array<Optional, 3> rotation_rad;
  std::array<Optional, 3> expanded_mm;
  std::array<Optional, 3> expanded_deg;
};

Optional in_degrees(Optional angle_rad) { return angle_rad ? Optional(*angle_rad * kDegrees) : std::nullopt; }

Numbers numbers_in(const Reading& reading) {
  Numbers numbers;
  if (!reading.pose) return numbers;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    numbers.position_mm[axis] = reading.pose->position_mm[i];
    numbers.expanded_mm[axis] = reading.pose->expanded_mm[i];
  }
  if (!reading.pose->orientation) return numbers;
  const Orientation& orientation = *reading.pose->orientation;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    numbers.abc_deg[axis] = orientation.abc_rad[i] * kDegrees;
    numbers.rotation_rad[axis] = orientation.rotation_vector_rad[i];
  }
  for (int i = 0; i < 4; ++i) numbers.quaternion[static_cast<std::size_t>(i)] = orientation.quaternion_wxyz[i];
  numbers.expanded_deg = {in_degrees(orientation.expanded_a_rad), orientation.expanded_b_rad * kDegrees,
                          in_degrees(orientation.expanded_c_rad)};
  return numbers;
}

std::uint16_t low_word(std::uint32_t sequence) { return static_cast<std::uint16_t>(sequence); }

/// True when all three can be shown: absent values can, as unknown.
template <typename T>
bool fits(const registers::OptionalField<T>& field, const std::array<Optional, 3>& values) {
  for (const Optional& value : values) {
    if (value && registers::raw_of(field, value) == field.unknown) return false;
  }
  return true;
}

/// A position that does not fit takes the whole pose with it; a rotation always fits.
Reading as_single(const Reading& reading) {
  return fits(registers::single::kX, numbers_in(reading).position_mm) ? reading : without_pose(reading);
}

template <typename Field, std::size_t N>
void put_each(RegisterImage& image, const std::array<Field, N>& fields, const std::array<Optional, N>& values,
              std::size_t shift) {
  for (std::size_t i = 0; i < N; ++i) image.put(fields[i], values[i], shift);
}

}  // namespace

void put_integer_pose(RegisterImage& image, const Reading& reading, std::size_t shift) {
  using namespace registers::measured;
  const Numbers numbers = numbers_in(reading);
  image.put(kSequence, low_word(reading.sequence), shift);
  image.put(kStatus, reading.status, shift);
  image.put(kFaults, reading.faults, shift);
  image.put(kWarnings, reading.warnings, shift);
  image.put(kTime, reading.time_ns, shift);
  image.put(kAge, reading.age_ms, shift);
  put_each(image, std::array{kX, kY, kZ}, numbers.position_mm, shift);
  put_each(image, std::array{kA, kB, kC}, numbers.abc_deg, shift);
  put_each(image, std::array{kQw, kQx, kQy, kQz}, numbers.quaternion, shift);
  put_each(image, std::array{kUncertaintyX, kUncertaintyY, kUncertaintyZ}, numbers.expanded_mm, shift);
  put_each(image, std::array{kUncertaintyA, kUncertaintyB, kUncertaintyC}, numbers.expanded_deg, shift);
  image.put(kResidual, reading.residual_px, shift);
  image.put(kPointsUsed, reading.points_used, shift);
  image.put(kSequenceLong, reading.sequence, shift);
  image.put(kSetup, reading.setup, shift);
  image.put(kSequenceEnd, low_word(reading.sequence), shift);
}

void put_float_pose(RegisterImage& image, const Reading& reading, std::size_t shift) {
  using namespace registers::measured_float;
  const Numbers numbers = numbers_in(reading);
  image.put(kSequence, low_word(reading.sequence), shift);
  image.put(kStatus, reading.status, shift);
  image.put(kFaults, reading.faults, shift);
  image.put(kWarnings, reading.warnings, shift);
  image.put(kTime, reading.time_ns, shift);
  image.put(kAge, reading.age_ms, shift);
  put_each(image, std::array{kX, kY, kZ}, numbers.position_mm, shift);
  put_each(image, std::array{kA, kB, kC}, numbers.abc_deg, shift);
  put_each(image, std::array{kQw, kQx, kQy, kQz}, numbers.quaternion, shift);
  put_each(image, std::array{kUncertaintyX, kUncertaintyY, kUncertaintyZ}, numbers.expanded_mm, shift);
  put_each(image, std::array{kUncertaintyA, kUncertaintyB, kUncertaintyC}, numbers.expanded_deg, shift);
  image.put(kResidual, reading.residual_px, shift);
  image.put(kSequenceLong, reading.sequence, shift);
  image.put(kSetup, reading.setup, shift);
  image.put(kSequenceEnd, low_word(reading.sequence), shift);
}

void put_single_pose(RegisterImage& image, const Reading& reading, std::size_t shift) {
  using namespace registers::single;
  const Reading shown = as_single(reading);
  const Numbers numbers = numbers_in(shown);
  image.put(kSequence, low_word(shown.sequence), shift);
  image.put(kStatus, shown.status, shift);
  image.put(kFaults, shown.faults, shift);
  image.put(kHeartbeat, shown.heartbeat, shift);
  put_each(image, std::array{kX, kY, kZ}, numbers.position_mm, shift);
  put_each(image, std::array{kRotationX, kRotationY, kRotationZ}, numbers.rotation_rad, shift);
  put_each(image, std::array{kUncertaintyX, kUncertaintyY, kUncertaintyZ}, numbers.expanded_mm, shift);
  image.put(kAge, shown.age_ms, shift);
  image.put(kSetup, shown.setup, shift);
  image.put(kSequenceEnd, low_word(shown.sequence), shift);
}

}  // namespace tripoint
