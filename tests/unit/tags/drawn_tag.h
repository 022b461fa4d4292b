// AprilTags drawn with known corners: a plane seen by a pinhole camera, every pixel the mean over its own area.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "ports/frame.h"
#include "tags/tag_decoder.h"
#include "values/linear.h"

namespace tripoint::test {

/// Rows of cells from above, with the quiet zone; the square with the corners is `across` cells wide and in the middle.
struct TagCells {
  std::vector<std::vector<bool>> light;
  int across = 8;
};

/// A tag of 36h11 by its code as published with AprilTag 2 (Olson 2011): 36 bits row by row from the upper left, 1 is
/// light, within a dark border of one cell and a light one around it.
TagCells tag36h11(std::uint64_t code);
/// Ids 0 to 2 of the family.
inline constexpr std::array<std::uint64_t, 3> kCodes36h11{0xd5d628584, 0xd97f18b49, 0xdd280910e};

/// How a tag's plane (its square from -1 to 1, x right, y down) appears: a homography to pixels.
using PixelsFromTag = Matrix3;
/// @param size_mm  of the tag's square; its centre at `centre_mm` of the camera's frame
PixelsFromTag seen_by_camera(const Matrix3& camera_from_tag, const Vec3& centre_mm, double size_mm);
std::array<Vec2, kTagCorners> corners_of(const PixelsFromTag& pixels_from_tag);

/// A grey sheet on which tags are drawn.
class Sheet {
 public:
  static constexpr double kLight = 200.0;
  static constexpr double kDark = 30.0;

  explicit Sheet(ImageSize size = {640, 480}, std::uint32_t seed = 1);

  /// Each pixel is the mean over a tent of two pixels' width: its own area, and a blur of the same size.
  void draw(const TagCells& cells, const PixelsFromTag& pixels_from_tag);
  void add_noise(double sigma);
  void add_noise(double sigma, std::uint32_t seed);
  void cover(int left_px, int top_px, int right_px, int bottom_px);
  /// A rectangle of one luma from one place to another, reaching so far to the right of that line, as the picture is
  /// shown.
  void lay_strip(const Vec2& from_px, const Vec2& to_px, double begin_px, double end_px, double luma);
  void mirror();
  /// What moves along u by so much while it is exposed.
  void smear(int width_px);
  void scale_contrast(double factor);

  /// Rounded to whole luma steps; a view that this sheet owns.
  Picture grey();

 private:
  double& at(int x, int y) { return values_[static_cast<std::size_t>(y * size_.width_px + x)]; }

  ImageSize size_;
  std::vector<double> values_;
  std::vector<std::uint8_t> bytes_;
  std::mt19937 random_;
};

}  // namespace tripoint::test
