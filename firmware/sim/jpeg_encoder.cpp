#include "sim/jpeg_encoder.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <jpeglib.h>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr std::size_t kBlock = 8;

struct Freed {
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): libjpeg takes it from malloc
  void operator()(unsigned char* bytes) const { std::free(bytes); }
};

/// Compressing a checked picture into memory cannot fail but by a bug or a lack of memory.
[[noreturn]] void stop(j_common_ptr /*info*/) {
  assertion_failed("libjpeg takes a simulated picture", __FILE__, __LINE__);
}

/// Chroma at half height: the mean of two rows.
std::vector<std::uint8_t> rows_halved(const std::vector<std::uint8_t>& plane, std::size_t width) {
  std::vector<std::uint8_t> halved(plane.size() / 2);
  for (std::size_t y = 0; y < halved.size() / width; ++y) {
    const std::uint8_t* upper = plane.data() + 2 * y * width;
    for (std::size_t x = 0; x < width; ++x) {
      halved[y * width + x] = static_cast<std::uint8_t>((upper[x] + upper[x + width] + 1) / 2);
    }
  }
  return halved;
}

void describe(jpeg_compress_struct& info, ImageSize size, ChromaSampling sampling, int quality) {
  info.image_width = static_cast<JDIMENSION>(size.width_px);
  info.image_height = static_cast<JDIMENSION>(size.height_px);
  info.input_components = 3;
  info.in_color_space = JCS_YCbCr;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  info.dct_method = JDCT_ISLOW;
  info.raw_data_in = TRUE;
  info.comp_info[0].h_samp_factor = 2;
  info.comp_info[0].v_samp_factor = sampling == ChromaSampling::k420 ? 2 : 1;
  for (int i = 1; i < 3; ++i) {
    info.comp_info[i].h_samp_factor = 1;
    info.comp_info[i].v_samp_factor = 1;
  }
}

/// Rows of one plane for one call of the library, which does not write to them.
std::array<JSAMPROW, 2 * kBlock> rows_from(const std::vector<std::uint8_t>& plane, std::size_t first,
                                           std::size_t width) {
  std::array<JSAMPROW, 2 * kBlock> rows{};
  for (std::size_t i = 0; i < rows.size() && (first + i + 1) * width <= plane.size(); ++i) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the library takes input as if it were output
    rows[i] = const_cast<JSAMPROW>(plane.data() + (first + i) * width);
  }
  return rows;
}

}  // namespace

std::vector<std::uint8_t> jpeg_from(const YuvPlanes& planes, ChromaSampling sampling, int quality) {
  const auto width = static_cast<std::size_t>(planes.size.width_px);
  const bool halve = sampling == ChromaSampling::k420;
  const std::vector<std::uint8_t> u = halve ? rows_halved(planes.u, width / 2) : planes.u;
  const std::vector<std::uint8_t> v = halve ? rows_halved(planes.v, width / 2) : planes.v;

  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  errors.error_exit = stop;
  jpeg_create_compress(&info);
  unsigned char* buffer = nullptr;
  unsigned long length = 0;
  jpeg_mem_dest(&info, &buffer, &length);
  describe(info, planes.size, sampling, quality);
  jpeg_start_compress(&info, TRUE);
  const std::size_t luma_rows = halve ? 2 * kBlock : kBlock;
  for (std::size_t y = 0; y < static_cast<std::size_t>(planes.size.height_px); y += luma_rows) {
    const std::size_t chroma_y = halve ? y / 2 : y;
    auto luma = rows_from(planes.y, y, width);
    auto chroma_u = rows_from(u, chroma_y, width / 2);
    auto chroma_v = rows_from(v, chroma_y, width / 2);
    std::array<JSAMPARRAY, 3> all{luma.data(), chroma_u.data(), chroma_v.data()};
    jpeg_write_raw_data(&info, all.data(), static_cast<JDIMENSION>(luma_rows));
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const std::unique_ptr<unsigned char, Freed> owned(buffer);
  return {buffer, buffer + length};
}

}  // namespace tripoint
