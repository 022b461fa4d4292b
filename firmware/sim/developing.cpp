#include "sim/developing.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr int kShift = 18;  // two chroma pixels together stay below 2^31
constexpr double kQuarterCountsAtClip = 4.0 * kClipCounts;

std::uint8_t byte_from(std::int32_t scaled, int shift) {
  return static_cast<std::uint8_t>(std::clamp(scaled >> shift, 0, 255));
}

/// The curve over quarter counts; empty when the tone changes nothing.
std::vector<std::int16_t> curve_of(const Tone& tone) {
  if (tone.gamma == 1.0 && tone.color_matrix == Matrix3::Identity()) return {};
  std::vector<std::int16_t> curve(4 * kClipCounts + 1);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double level = static_cast<double>(i) / kQuarterCountsAtClip;
    curve[i] = static_cast<std::int16_t>(std::lround(kQuarterCountsAtClip * std::pow(level, 1.0 / tone.gamma)));
  }
  return curve;
}

}  // namespace

Tone webcam_tone() {
  Tone tone{.gamma = 2.2};
  tone.color_matrix << 1.35, -0.28, -0.07, -0.15, 1.35, -0.20, -0.03, -0.30, 1.33;  // an ordinary sensor's, to sRGB
  return tone;
}

Developer::Weights Developer::weights(double red, double green, double blue, double offset) {
  const double scale = std::ldexp(1.0, kShift);
  const auto rounded = [&](double value) { return static_cast<std::int32_t>(std::lround(value * scale)); };
  return {.red = rounded(red / kQuarterCountsAtClip),
          .green = rounded(green / kQuarterCountsAtClip),
          .blue = rounded(blue / kQuarterCountsAtClip),
          .offset = rounded(offset + 0.5)};
}

Developer::Developer(ImageSize size, YuvRange range, const Tone& tone)
    : color_matrix_(tone.color_matrix.cast<float>()), curve_(curve_of(tone)) {
  const bool video = range == YuvRange::kVideo;
  const double luma = video ? 219.0 : 255.0;
  const double chroma = video ? 224.0 : 255.0;
  constexpr double kRed = 0.299;
  constexpr double kBlue = 0.114;
  constexpr double kGreen = 1.0 - kRed - kBlue;
  const double u = 0.5 * chroma / (1.0 - kBlue);
  const double v = 0.5 * chroma / (1.0 - kRed);
  luma_ = weights(luma * kRed, luma * kGreen, luma * kBlue, video ? 16.0 : 0.0);
  chroma_u_ = weights(-u * kRed, -u * kGreen, u * (1.0 - kBlue), 128.0);
  chroma_v_ = weights(v * (1.0 - kRed), -v * kGreen, -v * kBlue, 128.0);
  const auto width = static_cast<std::size_t>(size.width_px);
  const auto height = static_cast<std::size_t>(size.height_px);
  planes_ = {.size = size,
             .y = std::vector<std::uint8_t>(width * height),
             .u = std::vector<std::uint8_t>(width / 2 * height),
             .v = std::vector<std::uint8_t>(width / 2 * height)};
  is_odd_.resize(width);
  for (std::size_t x = 1; x < width; x += 2) is_odd_[x] = -1;
  red_.resize(width);
  green_.resize(width);
  blue_.resize(width);
}

void Developer::develop(const RawPlane& raw) {
  for (int y = 0; y < planes_.size.height_px; ++y) {
    demosaic_row(raw, y);
    if (!curve_.empty()) tone_row();
    convert_row(y);
  }
}

void Developer::demosaic_row(const RawPlane& raw, int y) {
  const bool red_row = (y & 1) == 0;  // red sits at even x of even rows, blue at odd x of odd rows
  const std::int16_t* above = raw.row(y - 1);
  const std::int16_t* here = raw.row(y);
  const std::int16_t* below = raw.row(y + 1);
  std::int16_t* own = red_row ? red_.data() : blue_.data();
  std::int16_t* other = red_row ? blue_.data() : red_.data();
  std::int16_t* green = green_.data();
  const std::int16_t* odd = is_odd_.data();
  const auto flip = static_cast<std::int16_t>(red_row ? -1 : 0);
  const std::ptrdiff_t width = planes_.size.width_px;
  for (std::ptrdiff_t x = 0; x < width; ++x) {
    const auto at_own = static_cast<std::int16_t>(odd[x] ^ flip);  // all bits set where `own` was measured
    const int center = 4 * here[x];
    const int sides = here[x - 1] + here[x + 1];
    const int rows = above[x] + below[x];
    const int corners = above[x - 1] + above[x + 1] + below[x - 1] + below[x + 1];
    own[x] = static_cast<std::int16_t>(at_own != 0 ? center : 2 * sides);
    green[x] = static_cast<std::int16_t>(at_own != 0 ? sides + rows : center);
    other[x] = static_cast<std::int16_t>(at_own != 0 ? corners : 2 * rows);
  }
}

void Developer::tone_row() {
  const auto toned = [this](float value) {
    return curve_[static_cast<std::size_t>(std::lround(std::clamp(value, 0.0F, 4.0F * kClipCounts)))];
  };
  for (std::size_t x = 0; x < red_.size(); ++x) {
    const Eigen::Vector3f color = color_matrix_ * Eigen::Vector3f(red_[x], green_[x], blue_[x]);
    red_[x] = toned(color.x());
    green_[x] = toned(color.y());
    blue_[x] = toned(color.z());
  }
}

void Developer::convert_row(int y) {
  const auto width = static_cast<std::size_t>(planes_.size.width_px);
  const auto row = static_cast<std::size_t>(y);
  std::uint8_t* luma = planes_.y.data() + row * width;
  std::uint8_t* chroma_u = planes_.u.data() + row * (width / 2);
  std::uint8_t* chroma_v = planes_.v.data() + row * (width / 2);
  const std::int16_t* red = red_.data();
  const std::int16_t* green = green_.data();
  const std::int16_t* blue = blue_.data();
  const Weights wy = luma_;
  const Weights wu = chroma_u_;
  const Weights wv = chroma_v_;
  for (std::size_t x = 0; x < width; ++x) {
    luma[x] = byte_from(wy.red * red[x] + wy.green * green[x] + wy.blue * blue[x] + wy.offset, kShift);
  }
  for (std::size_t i = 0; i < width / 2; ++i) {
    const int r = red[2 * i] + red[2 * i + 1];
    const int g = green[2 * i] + green[2 * i + 1];
    const int b = blue[2 * i] + blue[2 * i + 1];
    chroma_u[i] = byte_from(wu.red * r + wu.green * g + wu.blue * b + 2 * wu.offset, kShift + 1);
    chroma_v[i] = byte_from(wv.red * r + wv.green * g + wv.blue * b + 2 * wv.offset, kShift + 1);
  }
}

YuyvPacker::YuyvPacker(ImageSize size)
    : bytes_(2 * static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px)) {}

void YuyvPacker::pack(const YuvPlanes& planes) {
  const std::size_t pairs = planes.u.size();
  const std::uint8_t* y = planes.y.data();
  const std::uint8_t* u = planes.u.data();
  const std::uint8_t* v = planes.v.data();
  std::uint8_t* out = bytes_.data();
  for (std::size_t i = 0; i < pairs; ++i) {
    out[4 * i] = y[2 * i];
    out[4 * i + 1] = u[i];
    out[4 * i + 2] = y[2 * i + 1];
    out[4 * i + 3] = v[i];
  }
}

}  // namespace tripoint
