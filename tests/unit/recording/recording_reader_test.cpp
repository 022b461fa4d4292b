#include "recording/recording_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "recording_folder.h"

namespace tripoint {
namespace {

using test::RecordingFolder;
using test::refusal;
using testing::AllOf;
using testing::HasSubstr;

std::string png_of(int width, int height, png_uint_32 format, std::uint8_t value) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  const std::vector<std::uint8_t> values(PNG_IMAGE_SIZE(image), value);
  std::string png(4096, '\0');
  png_alloc_size_t size = png.size();
  png_image_write_to_memory(&image, png.data(), &size, 0, values.data(), 0, nullptr);
  png.resize(size);
  return png;
}

TEST(RecordingReaderTest, FramesComeInTheOrderOfTheFileWithTheirPictures) {
  const RecordingFolder folder;
  folder.describe("yuyv");
  folder.picture("left", 4, 'a');
  folder.picture("right", 9, 'b');
  folder.rows("right,9,100,200\nleft,4,90,210\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader) << reader.error().message;
  for (const auto& [side, sequence, value] : {std::tuple(Side::kRight, 9U, 'b'), std::tuple(Side::kLeft, 4U, 'a')}) {
    const auto item = reader->next();
    ASSERT_TRUE(item && *item);
    const auto& frame = std::get<Frame>(**item);
    EXPECT_EQ(frame.side, side);
    EXPECT_EQ(frame.sequence, sequence);
    EXPECT_EQ(frame.format, PixelFormat::kYuyv);
    EXPECT_EQ(frame.stride_bytes, 32U);
    EXPECT_EQ(frame.line_time, Duration{30'500});
    ASSERT_EQ(frame.data.size(), test::kYuyv_bytes);
    EXPECT_EQ(frame.data[0], static_cast<std::uint8_t>(value));
  }
  EXPECT_FALSE(reader->next());
}

TEST(RecordingReaderTest, LossAndReturnAreHandedOn) {
  const RecordingFolder folder;
  folder.describe("yuyv");
  folder.write("frames.csv", "camera,index,exposure_mid_ns,arrival_ns,event\nleft,,,5,lost\nright,,,6,back\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader) << reader.error().message;
  const auto lost = reader->next();
  ASSERT_TRUE(lost && *lost);
  EXPECT_EQ(std::get<CameraLost>(**lost).at, time_from_ns(5));
  const auto back = reader->next();
  ASSERT_TRUE(back && *back);
  EXPECT_EQ(std::get<CameraBack>(**back).side, Side::kRight);
}

TEST(RecordingReaderTest, JpgIsHandedOnUndecoded) {
  const RecordingFolder folder;
  folder.describe("jpg");
  folder.write("left/00000001.jpg", "any bytes");
  folder.rows("left,1,1,1\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader);
  const auto item = reader->next();
  ASSERT_TRUE(item && *item);
  EXPECT_EQ(std::get<Frame>(**item).format, PixelFormat::kMjpeg);
  EXPECT_EQ(std::get<Frame>(**item).data.size(), 9U);
}

TEST(RecordingReaderTest, PngBecomesYuyvOrGrey) {
  const RecordingFolder folder;
  folder.describe("png");
  folder.write("left/00000001.png", png_of(16, 16, PNG_FORMAT_RGB, 200));
  folder.write("left/00000002.png", png_of(16, 16, PNG_FORMAT_GRAY, 50));
  folder.rows("left,1,1,1\nleft,2,2,2\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader);
  const auto colour = reader->next();
  ASSERT_TRUE(colour && *colour);
  EXPECT_EQ(std::get<Frame>(**colour).format, PixelFormat::kYuyv);
  EXPECT_EQ(std::get<Frame>(**colour).data[0], 200);
  EXPECT_EQ(std::get<Frame>(**colour).data[1], 128);
  const auto grey = reader->next();
  ASSERT_TRUE(grey && *grey);
  EXPECT_EQ(std::get<Frame>(**grey).format, PixelFormat::kGrey);
  EXPECT_EQ(std::get<Frame>(**grey).stride_bytes, 16U);
}

TEST(RecordingReaderTest, AMissingPictureNamesRowAndFileAndReadingGoesOn) {
  const RecordingFolder folder;
  folder.describe("yuyv");
  folder.picture("left", 2, 'x');
  folder.rows("left,1,1,1\nleft,2,2,2\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader);
  const auto missing = reader->next();
  ASSERT_TRUE(missing);
  EXPECT_THAT(refusal(*missing), AllOf(HasSubstr("frames.csv:2"), HasSubstr("left/00000001.yuyv")));
  const auto present = reader->next();
  EXPECT_TRUE(present && *present);
}

TEST(RecordingReaderTest, APictureOfAnotherLengthIsCorrupt) {
  const RecordingFolder folder;
  folder.describe("yuyv");
  folder.write("left/00000001.yuyv", std::string(test::kYuyv_bytes - 1, 'x'));
  folder.rows("left,1,1,1\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader);
  const auto item = reader->next();
  ASSERT_TRUE(item);
  EXPECT_THAT(refusal(*item), HasSubstr("511 bytes, must be 512"));
  EXPECT_EQ(item->error().code, ErrorCode::kCorruptFrame);
}

TEST(RecordingReaderTest, APngOfAnotherSizeIsCorrupt) {
  const RecordingFolder folder;
  folder.describe("png");
  folder.write("left/00000001.png", png_of(16, 17, PNG_FORMAT_RGB, 1));
  folder.rows("left,1,1,1\n");
  auto reader = RecordingReader::open(folder.path());
  ASSERT_TRUE(reader);
  const auto item = reader->next();
  ASSERT_TRUE(item);
  EXPECT_THAT(refusal(*item), HasSubstr("16x17, must be 16x16"));
}

TEST(RecordingReaderTest, AFolderWithoutItsFilesNamesTheFirstThatIsMissing) {
  const RecordingFolder folder;
  EXPECT_THAT(refusal(RecordingReader::open(folder.path())), HasSubstr("recording.toml"));
  folder.describe("yuyv");
  EXPECT_THAT(refusal(RecordingReader::open(folder.path())), HasSubstr("frames.csv"));
}

TEST(RecordingReaderTest, ErrorsInTheFilesNameFileAndLine) {
  const RecordingFolder folder;
  folder.describe("bmp");
  folder.rows("left,1,1,1\n");
  EXPECT_THAT(refusal(RecordingReader::open(folder.path())), HasSubstr("recording.toml:2"));
  folder.describe("yuyv");
  folder.rows("left,1,1,1\nleft,0,2,2\n");
  EXPECT_THAT(refusal(RecordingReader::open(folder.path())), HasSubstr("frames.csv:3"));
}

}  // namespace
}  // namespace tripoint
