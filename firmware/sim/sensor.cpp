#include "sim/sensor.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/random_key.h"
#include "values/assert.h"

namespace tripoint {

std::vector<std::size_t> hot_pixels(const SensorModel& sensor, ImageSize size, std::uint64_t key) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(size.width_px) * static_cast<std::uint64_t>(size.height_px);
  std::vector<std::size_t> hot(
      static_cast<std::size_t>(std::lround(sensor.hot_pixel_share * static_cast<double>(pixels))));
  for (std::size_t i = 0; i < hot.size(); ++i) hot[i] = mixed(mixed(key) + i) % pixels;
  std::ranges::sort(hot);
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());  // of two that fell on one place, one is left
  return hot;
}

NoiseTable::NoiseTable(std::uint64_t seed, std::size_t longest_row)
    : longest_row_(longest_row), values_(kStarts + longest_row) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> drawn(values_.size());
  double sum = 0.0;
  double squares = 0.0;
  for (double& value : drawn) {
    value = normal(generator);
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(drawn.size());
  const double mean = sum / count;
  const double sigma = std::sqrt(squares / count - mean * mean);
  std::transform(drawn.begin(), drawn.end(), values_.begin(),
                 [&](double value) { return static_cast<float>((value - mean) / sigma); });
}

std::span<const float> NoiseTable::row(std::uint64_t key) const {
  return std::span(values_).subspan(mixed(key) % kStarts, longest_row_);
}

RawPlane::RawPlane(ImageSize size)
    : size_(size),
      stride_(static_cast<std::size_t>(size.width_px) + 2 * kRim),
      counts_(stride_ * static_cast<std::size_t>(size.height_px)) {}

void RawPlane::expose_row(int y, std::span<const float> expected, std::span<const float> noise,
                          const SensorModel& sensor) {
  const auto width = static_cast<std::size_t>(size_.width_px);
  TRIPOINT_ASSERT(expected.size() >= width && noise.size() >= width);
  std::int16_t* counts = counts_.data() + static_cast<std::size_t>(y) * stride_ + kRim;
  constexpr auto kClip = static_cast<float>(kClipCounts);
  constexpr auto kPedestal = static_cast<float>(kPedestalCounts);
  const auto read_variance = static_cast<float>(sensor.read_noise * sensor.read_noise);
  const auto shot_variance = static_cast<float>(1.0 / sensor.full_well_electrons);
  const float* level = expected.data();
  const float* normal = noise.data();
  for (std::size_t x = 0; x < width; ++x) {
    const float sigma = std::sqrt(read_variance + shot_variance * std::max(level[x], 0.0F));
    const float shifted = (level[x] + sigma * normal[x]) * kClip + kPedestal + 0.5F;
    const float kept = std::min(std::max(shifted, 0.0F), kClip + kPedestal + 0.5F);
    counts[x] = static_cast<std::int16_t>(static_cast<int>(kept) - kPedestalCounts);
  }
  counts[-1] = counts[1];
  counts[width] = counts[width - 2];
}

const std::int16_t* RawPlane::row(int y) const {
  const int mirrored = y < 0 ? -y : (y >= size_.height_px ? 2 * size_.height_px - 2 - y : y);
  return counts_.data() + static_cast<std::size_t>(mirrored) * stride_ + kRim;
}

}  // namespace tripoint
