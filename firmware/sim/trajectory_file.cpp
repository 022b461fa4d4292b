#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "sim/trajectory.h"

namespace tripoint {
namespace {

constexpr std::string_view kHeader = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz";
constexpr std::size_t kMaxRows = 1'000'000;
constexpr double kMaxNormError = 1e-2;  // of a quaternion: beyond this it is not one

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line;
}

std::optional<double> number_from(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  if (!trimmed({end, static_cast<std::size_t>(text.data() + text.size() - end)}).empty()) return std::nullopt;
  return value;
}

std::optional<TrajectorySample> sample_from(std::string_view line) {
  std::array<double, 8> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = line.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) return std::nullopt;
    const std::optional<double> value = number_from(line.substr(0, comma));
    if (!value) return std::nullopt;
    values[i] = *value;
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  const Eigen::Quaterniond rotation(values[4], values[5], values[6], values[7]);
  if (std::abs(rotation.norm() - 1.0) > kMaxNormError) return std::nullopt;
  return TrajectorySample{.t_s = values[0],
                          .in_reference_mm = {values[1], values[2], values[3]},
                          .reference_from_target = rotation.normalized()};
}

}  // namespace

Result<Trajectory> load_trajectory(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) return failure(ErrorCode::kCannotRead, "trajectory " + path.string() + ": cannot be opened");
  std::string line;
  std::vector<TrajectorySample> samples;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const std::string_view text = trimmed(line);
    if (number == 1) {
      if (text == kHeader) continue;
      return failure(ErrorCode::kMalformed,
                     "trajectory " + path.string() + ": line 1 must read " + std::string(kHeader));
    }
    if (text.empty()) continue;
    const std::optional<TrajectorySample> sample = sample_from(text);
    if (!sample || samples.size() == kMaxRows) {
      return failure(ErrorCode::kMalformed, "trajectory " + path.string() + ": line " + std::to_string(number) +
                                                ": needs eight numbers with a unit quaternion");
    }
    samples.push_back(*sample);
  }
  return interpolated(std::move(samples)).map_error([&](const Error& error) {
    return Error{error.code, "trajectory " + path.string() + ": " + error.message};
  });
}

}  // namespace tripoint
