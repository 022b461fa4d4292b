#include "capture/mjpeg_decoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "capture/jpeg_session.h"

namespace tripoint {
namespace {

/// How the components of one JPEG lie in memory and against each other.
struct Layout {
  ImageSize size;
  std::size_t components = 0;
  std::array<std::size_t, 3> stride_bytes{};
  std::array<std::size_t, 3> rows{};
  std::size_t rows_of_units = 0;
  int unit_height_px = 0;
  bool chroma_columns_halved = false;
  bool chroma_rows_halved = false;
};

tl::unexpected<Error> corrupt(std::string_view why) {
  return failure(ErrorCode::kCorruptFrame, fmt::format("JPEG not usable: {}", why));
}

bool fits(ImageSize size, std::optional<ImageSize> expected) {
  return (!expected || size == *expected) && size.width_px <= kMaxPictureSide_px &&
         size.height_px <= kMaxPictureSide_px;
}

bool of_known_kind(const jpeg_decompress_struct& header) {
  if (header.arith_code != FALSE || header.data_precision != 8) return false;
  if (header.num_components == 1) return header.jpeg_color_space == JCS_GRAYSCALE;
  return header.num_components == 3 && header.jpeg_color_space == JCS_YCbCr;
}

/// Luma at full resolution, both chroma planes at full or half of it in either direction.
bool sampled_as_cameras_do(const jpeg_decompress_struct& header) {
  const jpeg_component_info* component = header.comp_info;
  const int h = header.max_h_samp_factor;
  const int v = header.max_v_samp_factor;
  if (component[0].h_samp_factor != h || component[0].v_samp_factor != v) return false;
  if (header.num_components == 1) return true;
  const int chroma_h = component[1].h_samp_factor;
  const int chroma_v = component[1].v_samp_factor;
  return component[2].h_samp_factor == chroma_h && component[2].v_samp_factor == chroma_v &&
         (h == chroma_h || h == 2 * chroma_h) && (v == chroma_v || v == 2 * chroma_v);
}

Layout layout_of(const jpeg_decompress_struct& header) {
  Layout layout;
  layout.size = {static_cast<int>(header.image_width), static_cast<int>(header.image_height)};
  layout.components = static_cast<std::size_t>(header.num_components);
  layout.unit_height_px = header.max_v_samp_factor * DCTSIZE;
  layout.rows_of_units =
      static_cast<std::size_t>(layout.size.height_px - 1) / static_cast<std::size_t>(layout.unit_height_px) + 1;
  for (std::size_t c = 0; c < layout.components; ++c) {
    const jpeg_component_info& component = header.comp_info[c];
    const auto per_unit = static_cast<std::size_t>(component.h_samp_factor) * DCTSIZE;
    const auto unit_width = static_cast<std::size_t>(header.max_h_samp_factor) * DCTSIZE;
    layout.stride_bytes[c] = (header.image_width + unit_width - 1) / unit_width * per_unit;
    layout.rows[c] = layout.rows_of_units * static_cast<std::size_t>(component.v_samp_factor) * DCTSIZE;
  }
  if (layout.components == 3) {
    layout.chroma_columns_halved = header.comp_info[1].h_samp_factor != header.max_h_samp_factor;
    layout.chroma_rows_halved = header.comp_info[1].v_samp_factor != header.max_v_samp_factor;
  }
  return layout;
}

/// Which rows of MCUs were chosen.
using UnitRows = std::array<bool, kMaxPictureSide_px / DCTSIZE>;

UnitRows rows_in(const RowBands& bands, const Layout& layout) {
  UnitRows chosen{};
  for (std::size_t i = 0; i < layout.rows_of_units; ++i) {
    const int top_px = static_cast<int>(i) * layout.unit_height_px;
    chosen[i] = std::any_of(bands.begin(), bands.end(), [&](const RowBand& band) {
      return band.top_px < top_px + layout.unit_height_px && band.bottom_px > top_px;
    });
  }
  return chosen;
}

/// The rows that were chosen, as bands; no more than were asked for, since each holds one of those.
RowBands bands_of(const UnitRows& chosen, const Layout& layout) {
  RowBands bands;
  for (std::size_t i = 0; i < layout.rows_of_units; ++i) {
    if (!chosen[i]) continue;
    const int top_px = static_cast<int>(i) * layout.unit_height_px;
    if (i == 0 || !chosen[i - 1]) bands.push_back({top_px, top_px});
    bands.back().bottom_px = std::min(top_px + layout.unit_height_px, layout.size.height_px);
  }
  return bands;
}

/// 4:4:4 and 4:4:0 to half width, in place, in the rows of MCUs that were decoded.
void halve_columns(std::vector<std::uint8_t>& plane, const Layout& layout, std::size_t component,
                   const UnitRows& chosen) {
  const auto width = static_cast<std::size_t>(layout.size.width_px);
  const std::size_t rows_of_one = layout.rows[component] / layout.rows_of_units;
  for (std::size_t row = 0; row < layout.rows[component]; ++row) {
    if (!chosen[row / rows_of_one]) continue;
    std::uint8_t* values = plane.data() + row * layout.stride_bytes[component];
    for (std::size_t x = 0; x < width; x += 2) {
      const std::size_t next = std::min(x + 1, width - 1);
      values[x / 2] = static_cast<std::uint8_t>((values[x] + values[next] + 1) / 2);
    }
  }
}

using Planes = std::array<std::vector<std::uint8_t>, 3>;

Picture picture_in(Planes& planes, const Layout& layout, const UnitRows& chosen) {
  Picture picture{.size = layout.size,
                  .luma = {planes[0].data(), layout.stride_bytes[0], 1},
                  .u = {},
                  .v = {},
                  .chroma_rows_halved = layout.chroma_rows_halved};
  if (layout.components == 1) return picture;
  for (const std::size_t c : {1U, 2U}) {
    if (!layout.chroma_columns_halved) halve_columns(planes[c], layout, c, chosen);
  }
  picture.u = {planes[1].data(), layout.stride_bytes[1], 1};
  picture.v = {planes[2].data(), layout.stride_bytes[2], 1};
  return picture;
}

}  // namespace

Result<Picture> MjpegDecoder::decode(std::span<const std::uint8_t> jpeg, std::optional<ImageSize> expected,
                                     const RowBands& bands) {
  coded_ = {};
  JpegSession session(jpeg);
  if (!session.read_header()) return corrupt(session.error());
  const jpeg_decompress_struct& header = session.header();
  if (!fits({static_cast<int>(header.image_width), static_cast<int>(header.image_height)}, expected)) {
    return corrupt(fmt::format("{}x{} is not the expected size", header.image_width, header.image_height));
  }
  if (!of_known_kind(header) || !sampled_as_cameras_do(header)) return corrupt("a kind that no camera sends");

  const Layout layout = layout_of(header);
  std::array<JpegTarget, 3> targets;
  for (std::size_t c = 0; c < layout.components; ++c) {
    const std::size_t needed = layout.stride_bytes[c] * layout.rows[c];
    if (planes_[c].size() < needed) planes_[c].resize(needed);
    targets[c] = {planes_[c].data(), layout.stride_bytes[c]};
  }
  UnitRows chosen = rows_in(bands, layout);
  const RowBands decoded = bands_of(chosen, layout);
  if (decoded.empty()) chosen.fill(true);
  if (!session.read_planes(targets, chosen)) return corrupt(session.error());
  coded_ = session.scans();
  Picture picture = picture_in(planes_, layout, chosen);
  picture.bands = decoded;
  return picture;
}

}  // namespace tripoint
