#include "recording/recording_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tripoint {
namespace {

using testing::HasSubstr;

const std::string kGood =
    "format = \"tripoint-recording/1\"\npixel_format = \"jpg\"\nwidth_px = 640\nheight_px = 480\n";

std::string refusal(const std::string& toml) {
  const auto description = recording_description_from(toml, "recording.toml");
  return description ? "" : description.error().message;
}

std::string replaced(std::string_view what, std::string_view with) {
  std::string text = kGood;
  return text.replace(text.find(what), what.size(), with);
}

TEST(RecordingDescriptionTest, HoldsWhatTheFileSays) {
  const auto description =
      recording_description_from(kGood + "line_time_us = 30.5\nutc_offset_ns = 1700000000000000000\n", "f");
  ASSERT_TRUE(description) << description.error().message;
  EXPECT_EQ(description->format, RecordedFormat::kJpg);
  EXPECT_EQ(description->size, (ImageSize{640, 480}));
  EXPECT_EQ(description->line_time, Duration{30'500});
  EXPECT_EQ(description->utc_offset, Duration{1'700'000'000'000'000'000});
}

TEST(RecordingDescriptionTest, LineTimeAndOffsetAreZeroWhenAbsent) {
  const auto description = recording_description_from(kGood, "f");
  ASSERT_TRUE(description);
  EXPECT_EQ(description->line_time, Duration{0});
  EXPECT_EQ(description->utc_offset, Duration{0});
}

TEST(RecordingDescriptionTest, AnUnknownKeyIsRefusedWithItsLine) {
  EXPECT_THAT(refusal(kGood + "line_time_ms = 1\n"),
              testing::AllOf(HasSubstr("recording.toml:5"), HasSubstr("line_time_ms")));
}

TEST(RecordingDescriptionTest, AnotherFormatIsRefused) {
  EXPECT_THAT(refusal(replaced("recording/1", "recording/2")), HasSubstr("recording.toml:1"));
}
TEST(RecordingDescriptionTest, AnUnknownPixelFormatIsRefusedWithTheKnownOnes) {
  EXPECT_THAT(refusal(replaced("\"jpg\"", "\"bmp\"")), testing::AllOf(HasSubstr("pixel_format"), HasSubstr("yuyv")));
}
TEST(RecordingDescriptionTest, SizesOutOfRangeAreRefused) {
  EXPECT_EQ(refusal(replaced("640", "4096")), "");
  EXPECT_THAT(refusal(replaced("640", "4097")), HasSubstr("width_px"));
  EXPECT_EQ(refusal(replaced("480", "16")), "");
  EXPECT_THAT(refusal(replaced("480", "15")), HasSubstr("height_px"));
}
TEST(RecordingDescriptionTest, AMissingKeyIsNamed) {
  EXPECT_THAT(refusal(replaced("width_px = 640\n", "")), HasSubstr("width_px"));
}
TEST(RecordingDescriptionTest, YuyvHasNoOddWidth) {
  std::string text = replaced("640", "641");
  EXPECT_EQ(refusal(text), "");
  text.replace(text.find("jpg"), 3, "yuyv");
  EXPECT_THAT(refusal(text), HasSubstr("width_px"));
}
TEST(RecordingDescriptionTest, TextThatIsNoTomlIsRefused) { EXPECT_NE(refusal("format ="), ""); }

}  // namespace
}  // namespace tripoint
