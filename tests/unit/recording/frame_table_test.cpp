#include "recording/frame_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tripoint {
namespace {

using testing::HasSubstr;

const std::string kHeader = "camera,index,exposure_mid_ns,arrival_ns\n";

std::string refusal(const std::string& csv) {
  const auto rows = recorded_rows_from(csv, "frames.csv");
  return rows ? "" : rows.error().message;
}

TEST(FrameTableTest, RowsKeepTheOrderOfTheFile) {
  const auto rows = recorded_rows_from(kHeader + "right,7,1000,2000\nleft,3,900,2100\n", "f");
  ASSERT_TRUE(rows) << rows.error().message;
  ASSERT_EQ(rows->size(), 2U);
  EXPECT_EQ((*rows)[0].side, Side::kRight);
  EXPECT_EQ((*rows)[0].index, 7U);
  EXPECT_EQ((*rows)[0].exposed, time_from_ns(1000));
  EXPECT_EQ((*rows)[0].arrived, time_from_ns(2000));
  EXPECT_EQ((*rows)[1].side, Side::kLeft);
  EXPECT_EQ((*rows)[1].line, 3U);
}

TEST(FrameTableTest, ForecastAndEventAreRead) {
  const auto rows = recorded_rows_from(
      "camera,index,exposure_mid_ns,arrival_ns,forecast,event\nleft,1,10,20,55,\nleft,,,30,,lost\nleft,,,40,,back\n",
      "f");
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ((*rows)[0].forecast, 55U);
  EXPECT_EQ((*rows)[0].kind, RowKind::kFrame);
  EXPECT_EQ((*rows)[1].kind, RowKind::kCameraLost);
  EXPECT_EQ((*rows)[1].arrived, time_from_ns(30));
  EXPECT_EQ((*rows)[2].kind, RowKind::kCameraBack);
}

TEST(FrameTableTest, OneOptionalColumnMayStandAlone) {
  EXPECT_EQ(refusal("camera,index,exposure_mid_ns,arrival_ns,event\nleft,1,2,3,\nleft,,,3,lost\n"), "");
  EXPECT_EQ(refusal("camera,index,exposure_mid_ns,arrival_ns,forecast\nleft,1,2,3,9\n"), "");
}

TEST(FrameTableTest, WindowsLineEndsAndAMissingLastOneAreRead) {
  EXPECT_EQ(refusal("camera,index,exposure_mid_ns,arrival_ns\r\nleft,1,2,3\r\nleft,2,3,4"), "");
}

TEST(FrameTableTest, AnotherHeaderIsRefused) {
  EXPECT_THAT(refusal("camera,index,arrival_ns\nleft,1,2\n"), HasSubstr("frames.csv:1"));
  EXPECT_THAT(refusal("camera,index,exposure_mid_ns,arrival_ns,colour\n"), HasSubstr("header"));
  EXPECT_THAT(refusal(""), HasSubstr("header"));
}

TEST(FrameTableTest, EachBadCellIsNamedWithItsLine) {
  EXPECT_THAT(refusal(kHeader + "left,1,2,3\nmiddle,2,3,4\n"), HasSubstr("frames.csv:3: camera"));
  EXPECT_THAT(refusal(kHeader + "left,-1,2,3\n"), HasSubstr("frames.csv:2: index"));
  EXPECT_THAT(refusal(kHeader + "left,4294967296,2,3\n"), HasSubstr("index"));
  EXPECT_THAT(refusal(kHeader + "left,1,x,3\n"), HasSubstr("exposure_mid_ns"));
  EXPECT_THAT(refusal(kHeader + "left,1,2,3.5\n"), HasSubstr("arrival_ns"));
  EXPECT_THAT(refusal(kHeader + "left,1,2,-3\n"), HasSubstr("arrival_ns"));
  EXPECT_THAT(refusal(kHeader + "left,1,2\n"), HasSubstr("4 columns"));
  EXPECT_THAT(refusal(kHeader + "left,1,2,3,4,5,6,7\n"), HasSubstr("4 columns"));
  EXPECT_THAT(refusal(kHeader + "\n"), HasSubstr("columns"));
  EXPECT_THAT(refusal("camera,index,exposure_mid_ns,arrival_ns,event\nleft,1,2,3,gone\n"), HasSubstr("event"));
}

TEST(FrameTableTest, TheIndexOfACameraMustRise) {
  EXPECT_EQ(refusal(kHeader + "left,1,10,20\nright,1,10,20\nleft,2,11,21\n"), "");
  EXPECT_THAT(refusal(kHeader + "left,1,10,20\nright,1,10,20\nleft,1,11,21\n"), HasSubstr("frames.csv:4: index"));
}

TEST(FrameTableTest, TheArrivalOfACameraMustNotFall) {
  EXPECT_EQ(refusal(kHeader + "left,1,10,20\nright,1,10,19\nleft,2,11,20\n"), "");
  EXPECT_THAT(refusal(kHeader + "left,1,10,20\nleft,2,11,19\n"), HasSubstr("frames.csv:3: arrival_ns"));
}

TEST(FrameTableTest, StampsOfExposureMayJitterPastEachOther) {
  EXPECT_EQ(refusal(kHeader + "left,1,12,20\nleft,2,11,21\n"), "");
}

}  // namespace
}  // namespace tripoint
