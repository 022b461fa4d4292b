#include "sim/jpeg_encoder.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <jpeglib.h>

#include "sim/renderer.h"
#include "still_world.h"

namespace tripoint {
namespace {

struct Decoded {
  int width = 0;
  int height = 0;
  std::array<int, 2> luma_sampling{};
  std::vector<std::uint8_t> ycc;  ///< three bytes a pixel
};

/// By the library's own upsampling, without colour conversion.
Decoded decoded(const std::vector<std::uint8_t>& jpeg) {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, jpeg.data(), jpeg.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = JCS_YCbCr;
  Decoded result{.width = static_cast<int>(info.image_width),
                 .height = static_cast<int>(info.image_height),
                 .luma_sampling = {info.comp_info[0].h_samp_factor, info.comp_info[0].v_samp_factor},
                 .ycc = std::vector<std::uint8_t>(std::size_t{3} * info.image_width * info.image_height)};
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = result.ycc.data() + std::size_t{3} * info.output_scanline * info.output_width;
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  jpeg_destroy_decompress(&info);
  EXPECT_EQ(errors.num_warnings, 0);
  return result;
}

/// Smooth luma and slow chroma: what a JPEG of high quality keeps.
YuvPlanes smooth_planes() {
  YuvPlanes planes;
  planes.size = {.width_px = 64, .height_px = 48};
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      planes.y.push_back(static_cast<std::uint8_t>(128 + 60 * std::sin(0.1 * x) + 30 * std::cos(0.12 * y)));
    }
    for (int x = 0; x < 32; ++x) {
      planes.u.push_back(static_cast<std::uint8_t>(100 + x));
      planes.v.push_back(static_cast<std::uint8_t>(150 + y / 2));
    }
  }
  return planes;
}

void expect_close(const YuvPlanes& planes, const Decoded& picture, int tolerance) {
  for (std::size_t y = 4; y < 44; ++y) {
    for (std::size_t x = 4; x < 60; ++x) {
      const std::size_t i = 3 * (64 * y + x);
      ASSERT_NEAR(picture.ycc[i], planes.y[64 * y + x], tolerance) << x << ' ' << y;
      ASSERT_NEAR(picture.ycc[i + 1], planes.u[32 * y + x / 2], tolerance) << x << ' ' << y;
      ASSERT_NEAR(picture.ycc[i + 2], planes.v[32 * y + x / 2], tolerance) << x << ' ' << y;
    }
  }
}

// Quality 100 quantises every coefficient to whole steps: each of 64 is off by at most 0.5, a pixel by 0.3 RMS; the
// chroma ramps add half a step by upsampling. Three steps hold both.
TEST(JpegEncoderTest, DecodedPictureIsTheEncodedOne) {
  const YuvPlanes planes = smooth_planes();
  for (const ChromaSampling sampling : {ChromaSampling::k422, ChromaSampling::k420}) {
    const Decoded picture = decoded(jpeg_from(planes, sampling, 100));
    ASSERT_EQ(picture.width, 64);
    ASSERT_EQ(picture.height, 48);
    expect_close(planes, picture, 3);
  }
}

TEST(JpegEncoderTest, SamplingIsWhatWasAskedFor) {
  const YuvPlanes planes = smooth_planes();
  EXPECT_EQ(decoded(jpeg_from(planes, ChromaSampling::k422, 80)).luma_sampling, (std::array<int, 2>{2, 1}));
  EXPECT_EQ(decoded(jpeg_from(planes, ChromaSampling::k420, 80)).luma_sampling, (std::array<int, 2>{2, 2}));
}

TEST(JpegEncoderTest, LowerQualityIsSmaller) {
  const YuvPlanes planes = smooth_planes();
  EXPECT_LT(jpeg_from(planes, ChromaSampling::k422, 40).size(), jpeg_from(planes, ChromaSampling::k422, 95).size());
}

TEST(JpegEncoderTest, RenderedMjpegFrameDecodesWithTheSpotAtTheTruth) {
  SimulationSettings settings;
  settings.format = PixelFormat::kMjpeg;
  settings.trajectory = straight({0.0, 0.0, 400.0}, Vec3::Zero());
  const RenderedFrame frame = render(world_of(settings), Side::kLeft, kHalfWay);
  EXPECT_EQ(frame.stride_bytes, 0U);
  const Decoded picture = decoded(frame.pixels);
  ASSERT_EQ(picture.width, 640);
  ASSERT_EQ(picture.height, 480);
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < 640U * 480U; ++i) {
    if (picture.ycc[3 * i] > picture.ycc[3 * brightest]) brightest = i;
  }
  // the clipped top of the spot is about 2 sigma = 4 px wide
  EXPECT_NEAR(static_cast<double>(brightest % 640), frame.truth.lights[0].at.u_px, 2.5);
  EXPECT_NEAR(static_cast<double>(brightest / 640), frame.truth.lights[0].at.v_px, 2.5);
}

}  // namespace
}  // namespace tripoint
