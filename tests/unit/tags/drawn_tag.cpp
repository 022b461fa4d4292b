#include "drawn_tag.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tripoint::test {
namespace {

constexpr double kFocal_px = 628.0;
constexpr double kGround = 120.0;  // luma of the sheet
constexpr int kStrata = 8;         // samples of a pixel to each side

/// Of a tent from -1 to 1, the place below which lies the share u.
double tent_quantile(double u) { return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - u)); }

Vec2 projected(const Matrix3& homography, const Vec2& place) {
  return (homography * place.homogeneous()).hnormalized();
}

}  // namespace

TagCells tag36h11(std::uint64_t code) {
  constexpr int kBits = 6;
  constexpr int kCells = kBits + 4;
  TagCells cells{std::vector(kCells, std::vector<bool>(kCells, true)), kBits + 2};
  for (int row = 1; row < kCells - 1; ++row) {
    for (int column = 1; column < kCells - 1; ++column) {
      const int y = row - 2;
      const int x = column - 2;
      const bool data = y >= 0 && y < kBits && x >= 0 && x < kBits;
      const int bit = kBits * kBits - 1 - (y * kBits + x);
      cells.light[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          data && ((code >> static_cast<unsigned>(bit)) & 1U) != 0;
    }
  }
  return cells;
}

PixelsFromTag seen_by_camera(const Matrix3& camera_from_tag, const Vec3& centre_mm, double size_mm) {
  Matrix3 camera;
  camera << kFocal_px, 0.0, 320.0, 0.0, kFocal_px, 240.0, 0.0, 0.0, 1.0;
  Matrix3 plane;
  plane << camera_from_tag.col(0) * size_mm / 2.0, camera_from_tag.col(1) * size_mm / 2.0, centre_mm;
  return camera * plane;
}

std::array<Vec2, kTagCorners> corners_of(const PixelsFromTag& pixels_from_tag) {
  return {projected(pixels_from_tag, {-1.0, 1.0}), projected(pixels_from_tag, {1.0, 1.0}),
          projected(pixels_from_tag, {1.0, -1.0}), projected(pixels_from_tag, {-1.0, -1.0})};
}

Sheet::Sheet(ImageSize size, std::uint32_t seed)
    : size_(size), values_(static_cast<std::size_t>(size.width_px * size.height_px), kGround), random_(seed) {}

void Sheet::draw(const TagCells& cells, const PixelsFromTag& pixels_from_tag) {
  const auto count = static_cast<int>(cells.light.size());
  const double edge = static_cast<double>(count) / cells.across;  // of the outermost cells, in the tag's own measure
  Vec2 low = projected(pixels_from_tag, {-edge, -edge});
  Vec2 high = low;
  for (const Vec2& corner : {Vec2(edge, -edge), Vec2(edge, edge), Vec2(-edge, edge)}) {
    low = low.cwiseMin(projected(pixels_from_tag, corner));
    high = high.cwiseMax(projected(pixels_from_tag, corner));
  }
  const Matrix3 tag_from_pixels = pixels_from_tag.inverse();
  std::uniform_real_distribution<double> within(0.0, 1.0);
  for (int y = std::max(0, static_cast<int>(low.y()) - 1); y <= std::min(size_.height_px - 1.0, high.y() + 1); ++y) {
    for (int x = std::max(0, static_cast<int>(low.x()) - 1); x <= std::min(size_.width_px - 1.0, high.x() + 1); ++x) {
      double sum = 0.0;
      for (int i = 0; i < kStrata * kStrata; ++i) {
        const Vec2 place(x + tent_quantile((i % kStrata + within(random_)) / kStrata),
                         y + tent_quantile((i / kStrata + within(random_)) / kStrata));
        const Vec2 cell = ((projected(tag_from_pixels, place) * cells.across).array() + count) / 2.0;
        if (cell.minCoeff() < 0.0 || cell.maxCoeff() >= count) {
          sum += at(x, y);
        } else {
          sum += cells.light[static_cast<std::size_t>(cell.y())][static_cast<std::size_t>(cell.x())] ? kLight : kDark;
        }
      }
      at(x, y) = sum / (kStrata * kStrata);
    }
  }
}

void Sheet::add_noise(double sigma) {
  std::normal_distribution<double> noise(0.0, sigma);
  for (double& value : values_) value += noise(random_);
}

void Sheet::add_noise(double sigma, std::uint32_t seed) {
  random_.seed(seed);
  add_noise(sigma);
}

void Sheet::cover(int left_px, int top_px, int right_px, int bottom_px) {
  for (int y = top_px; y < bottom_px; ++y) {
    for (int x = left_px; x < right_px; ++x) at(x, y) = kGround;
  }
}

void Sheet::lay_strip(const Vec2& from_px, const Vec2& to_px, double begin_px, double end_px, double luma) {
  const double length_px = (to_px - from_px).norm();
  const Vec2 along = (to_px - from_px) / length_px;
  const Vec2 right(-along.y(), along.x());
  const auto within = [&](const Vec2& place, double margin_px) {
    const double distance_px = right.dot(place - from_px);
    const double along_px = along.dot(place - from_px);
    return distance_px >= begin_px - margin_px && distance_px < end_px + margin_px && along_px >= -margin_px &&
           along_px < length_px + margin_px;
  };
  for (int y = 0; y < size_.height_px; ++y) {
    for (int x = 0; x < size_.width_px; ++x) {
      if (!within({x, y}, 1.0)) continue;
      int covered = 0;
      for (int i = 0; i < kStrata * kStrata; ++i) {
        const Vec2 place(x + (i % kStrata + 0.5) / kStrata - 0.5, y + (i / kStrata + 0.5) / kStrata - 0.5);
        covered += within(place, 0.0) ? 1 : 0;
      }
      at(x, y) += covered * (luma - at(x, y)) / (kStrata * kStrata);
    }
  }
}

void Sheet::smear(int width_px) {
  for (int y = 0; y < size_.height_px; ++y) {
    const std::vector<double> row(&at(0, y), &at(0, y) + size_.width_px);
    for (int x = 0; x < size_.width_px; ++x) {
      double sum = 0.0;
      for (int k = 0; k < width_px; ++k) {
        const int from = std::clamp(x + k - width_px / 2, 0, size_.width_px - 1);
        sum += row[static_cast<std::size_t>(from)];
      }
      at(x, y) = sum / width_px;
    }
  }
}

void Sheet::mirror() {
  for (int y = 0; y < size_.height_px; ++y) {
    std::reverse(&at(0, y), &at(0, y) + size_.width_px);
  }
}

void Sheet::scale_contrast(double factor) {
  for (double& value : values_) value = kGround + factor * (value - kGround);
}

Picture Sheet::grey() {
  bytes_.clear();
  for (const double value : values_) {
    bytes_.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))));
  }
  return picture_of({.format = PixelFormat::kGrey,
                     .size = size_,
                     .stride_bytes = static_cast<std::size_t>(size_.width_px),
                     .data = bytes_});
}

}  // namespace tripoint::test
