#include "noise.h"

#include <algorithm>
#include <cstdio>  // jpeglib.h needs FILE
#include <cstdlib>

#include <jpeglib.h>

#include "pictures.h"

namespace tripoint::uvc {
namespace {

constexpr std::size_t kBits = 16;

bool has_bit(std::uint64_t frame, std::size_t bit) { return (frame >> bit & 1U) != 0; }

/// Raises the mean of the first blocks of 8 x 8 by two levels. Libjpeg's own errors end the program.
void mark_blocks(jpeg_decompress_struct& in, jvirt_barray_ptr luma, std::uint64_t frame) {
  constexpr int kTwoLevels = 16;  // of the first coefficient, which is eight times the mean
  const int quantum = in.comp_info[0].quant_table->quantval[0];
  JBLOCKARRAY row = in.mem->access_virt_barray(reinterpret_cast<j_common_ptr>(&in), luma, 0, 1, TRUE);
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    if (has_bit(frame, bit)) row[0][bit][0] = static_cast<JCOEF>(row[0][bit][0] + std::max(1, kTwoLevels / quantum));
  }
}

Bytes written(jpeg_decompress_struct& in, jvirt_barray_ptr* coefficients) {
  jpeg_error_mgr errors{};
  jpeg_compress_struct out{};
  out.err = jpeg_std_error(&errors);
  jpeg_create_compress(&out);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&out, &memory, &size);
  jpeg_copy_critical_parameters(&in, &out);
  jpeg_write_coefficients(&out, coefficients);
  jpeg_finish_compress(&out);
  jpeg_destroy_compress(&out);
  Bytes jpeg(memory, memory + size);
  std::free(memory);
  return jpeg;
}

Bytes noisy_jpeg(const Bytes& picture, std::uint64_t frame) {
  jpeg_error_mgr errors{};
  jpeg_decompress_struct in{};
  in.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&in);
  jpeg_mem_src(&in, picture.data(), static_cast<unsigned long>(picture.size()));
  jpeg_read_header(&in, TRUE);
  jvirt_barray_ptr* coefficients = jpeg_read_coefficients(&in);
  mark_blocks(in, coefficients[0], frame);
  const Bytes jpeg = written(in, coefficients);
  jpeg_destroy_decompress(&in);
  return without_huffman_tables(jpeg);
}

Bytes noisy_yuyv(Bytes picture, std::uint64_t frame) {
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    std::uint8_t& luma = picture[2 * bit];
    luma = static_cast<std::uint8_t>(luma ^ (has_bit(frame, bit) ? 1U : 0U));
  }
  return picture;
}

}  // namespace

Bytes with_noise(const Bytes& picture, Format format, std::uint64_t frame) {
  return format == Format::kMjpeg ? noisy_jpeg(picture, frame) : noisy_yuyv(picture, frame);
}

}  // namespace tripoint::uvc
