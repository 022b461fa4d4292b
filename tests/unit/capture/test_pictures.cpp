#include "test_pictures.h"

#include <png.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#include <algorithm>
#include <string>

#include "places.h"

namespace tripoint::test {
namespace {

/// Cuts every DHT segment (FF C4) out of a baseline JPEG's header.
std::vector<std::uint8_t> without_huffman_tables(const std::vector<std::uint8_t>& jpeg) {
  std::vector<std::uint8_t> out(jpeg.begin(), jpeg.begin() + 2);
  std::size_t at = 2;
  while (jpeg[at + 1] != 0xDA) {
    const std::size_t length = 2U + jpeg[at + 2] * 256U + jpeg[at + 3];
    const auto first = jpeg.begin() + static_cast<std::ptrdiff_t>(at);
    if (jpeg[at + 1] != 0xC4) out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(length));
    at += length;
  }
  out.insert(out.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(at), jpeg.end());
  return out;
}

std::vector<jpeg_scan_info> script_of_many_scans() {
  std::vector<jpeg_scan_info> script{{3, {0, 1, 2, 0}, 0, 0, 0, 0}};
  for (int coefficient = 1; coefficient <= 40; ++coefficient) {
    script.push_back({1, {0, 0, 0, 0}, coefficient, coefficient, 0, 0});
  }
  return script;
}

void write_rows(jpeg_compress_struct& codec, const SmoothPicture& picture) {
  const auto channels = static_cast<std::size_t>(codec.input_components);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(picture.size.width_px) * channels);
  for (int y = 0; y < picture.size.height_px; ++y) {
    for (int x = 0; x < picture.size.width_px; ++x) {
      std::uint8_t* pixel = row.data() + static_cast<std::size_t>(x) * channels;
      pixel[0] = static_cast<std::uint8_t>(picture.luma(x, y));
      if (channels == 1) continue;
      pixel[1] = static_cast<std::uint8_t>(picture.u(x, y));
      pixel[2] = static_cast<std::uint8_t>(picture.v(x, y));
    }
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&codec, &pointer, 1);
  }
}

}  // namespace

SmoothPicture smooth_picture(ImageSize size) {
  return {size, [](int x, int y) { return 40 + (x + y) / 2 % 160; }, [](int x, int) { return 100 + x / 8 % 50; },
          [](int, int y) { return 110 + y / 8 % 60; }};
}

std::vector<std::uint8_t> jpeg_of(const SmoothPicture& picture, const JpegKind& kind) {
  jpeg_compress_struct codec{};
  jpeg_error_mgr errors{};
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&codec, &memory, &size);
  codec.image_width = static_cast<JDIMENSION>(picture.size.width_px);
  codec.image_height = static_cast<JDIMENSION>(picture.size.height_px);
  codec.input_components = kind.grey ? 1 : 3;
  codec.in_color_space = kind.grey ? JCS_GRAYSCALE : JCS_YCbCr;
  jpeg_set_defaults(&codec);
  jpeg_set_quality(&codec, kind.quality, TRUE);
  if (!kind.grey) {
    codec.comp_info[0].h_samp_factor = kind.luma_h;
    codec.comp_info[0].v_samp_factor = kind.luma_v;
  }
  if (kind.progressive) jpeg_simple_progression(&codec);
  const std::vector<jpeg_scan_info> script = script_of_many_scans();
  if (kind.many_scans) {
    codec.scan_info = script.data();
    codec.num_scans = static_cast<int>(script.size());
  }
  jpeg_start_compress(&codec, TRUE);
  write_rows(codec, picture);
  jpeg_finish_compress(&codec);
  std::vector<std::uint8_t> jpeg(memory, memory + size);
  jpeg_destroy_compress(&codec);
  std::free(memory);
  return kind.without_tables ? without_huffman_tables(jpeg) : jpeg;
}

std::vector<std::uint8_t> png_of(ImageSize size, bool colour, const std::vector<std::uint8_t>& values) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(size.width_px);
  image.height = static_cast<png_uint_32>(size.height_px);
  image.format = colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  png_alloc_size_t bytes = 0;
  png_image_write_to_memory(&image, nullptr, &bytes, 0, values.data(), 0, nullptr);
  std::vector<std::uint8_t> png(bytes);
  png_image_write_to_memory(&image, png.data(), &bytes, 0, values.data(), 0, nullptr);
  png.resize(bytes);
  return png;
}

std::filesystem::path shared_data() { return shared_folder() / "data"; }

}  // namespace tripoint::test
