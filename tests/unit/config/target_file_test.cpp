#include "config/target_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "format = \"tripoint-target/1\"\ndetector = \"led\"\n";
const std::string kTags = "format = \"tripoint-target/1\"\ndetector = \"apriltag\"\nfamily = \"tag36h11\"\n";

std::string point(int id, const std::string& position) {
  return "[[points]]\nid = " + std::to_string(id) + "\nposition_mm = " + position + "\n";
}

/// On a parabola, which no turn brings onto itself.
std::string points(int count) {
  std::string text = kHead;
  for (int i = 1; i <= count; ++i)
    text += point(i, "[" + std::to_string(10 * i) + ", " + std::to_string(i * i) + ", 0]");
  return text;
}

std::string message_of(const std::string& text) {
  const Result<TargetFile> target = parse_target(text, "t.toml");
  return target ? "" : target.error().message;
}

TEST(TargetFileTest, PointsAreRead) {
  const TargetFile t = parse_target("facing = [0, 0, 2]\n" + kHead + point(1, "[0, 0, 0]") + "uncertainty_mm = 0.1\n" +
                                        point(7, "[60, 1.5, -2]"),
                                    "")
                           .value();
  EXPECT_EQ(t.kind, TargetKind::kLed);
  ASSERT_EQ(t.points.size(), 2U);
  EXPECT_EQ(t.points[0].uncertainty_mm, 0.1);
  EXPECT_EQ(t.points[1].id, 7);
  EXPECT_EQ(t.points[1].position_mm, Vec3(60.0, 1.5, -2.0));
  EXPECT_EQ(t.points[1].uncertainty_mm, 0.05);
  EXPECT_EQ(*t.facing, Vec3::UnitZ());
}

TEST(TargetFileTest, AFacingAfterThePointsBelongsToTheLastOfThem) {
  const TargetFile t = parse_target(kHead + point(1, "[0, 0, 0]") + "facing = [0, 1, 0]\n", "").value();
  EXPECT_FALSE(t.facing.has_value());
  EXPECT_EQ(*t.points[0].facing, Vec3::UnitY());
}

TEST(TargetFileTest, NoDirectionIsNoFacing) {
  EXPECT_THAT(message_of("facing = [0, 0, 0]\n" + kHead + point(1, "[0, 0, 0]")),
              HasSubstr("permitted is a direction"));
}

TEST(TargetFileTest, ASinglePointLiesAtTheOrigin) {
  EXPECT_EQ(message_of(kHead + point(1, "[0, 0, 0]")), "");
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 1]")), HasSubstr("position_mm = [0, 0, 0]"));
}

TEST(TargetFileTest, OneToTwelvePointsMakeATarget) {
  EXPECT_EQ(message_of(points(12)), "");
  EXPECT_THAT(message_of(points(13)), HasSubstr("permitted is 1 to 12 points"));
  EXPECT_THAT(message_of(kHead), HasSubstr("permitted is 1 to 12 points"));
}

TEST(TargetFileTest, AnIdTwiceIsAnError) {
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(1, "[10, 0, 0]")),
              HasSubstr("t.toml:7: points[1].id = 1: permitted is each id once"));
}

TEST(TargetFileTest, PointsInOnePlaceAreAnError) {
  EXPECT_EQ(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[2.5, 0, 0]")), "");
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[2.49, 0, 0]")), HasSubstr("2.5 mm or more"));
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[0, 0, 0]")), HasSubstr("t.toml:8: points[1]"));
}

TEST(TargetFileTest, PointsAMetreApartAreAnError) {
  EXPECT_EQ(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[999, 0, 0]")), "");
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[1000, 0, 0]")), HasSubstr("less than 1000 mm"));
}

TEST(TargetFileTest, PlacesThatAreNoNumbersAreAnError) {
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[nan, 0, 0]")), HasSubstr("t.toml:8: points[1]"));
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[inf, 0, 0]")), HasSubstr("3 numbers"));
}

TEST(TargetFileTest, AShapeThatDoesNotTellWhichIsWhichIsAnErrorWithARemedy) {
  const std::string message =
      message_of(kHead + point(1, "[0, 0, 0]") + point(2, "[60, 0, 0]") + point(3, "[30, 40, 0]"));
  EXPECT_THAT(message, HasSubstr("t.toml:3: points: an isosceles triangle"));
  EXPECT_THAT(message, HasSubstr("; move points[2] to ["));
}

TEST(TargetFileTest, AnotherErrorIsSaidBeforeTheShape) {
  EXPECT_THAT(
      message_of(kHead + "colour = 1\n" + point(1, "[0, 0, 0]") + point(2, "[60, 0, 0]") + point(3, "[30, 40, 0]")),
      HasSubstr("unknown key colour"));
}

TEST(TargetFileTest, TagsAreRead) {
  const TargetFile t =
      parse_target(kTags + "[[tags]]\nid = 0\nsize_mm = 40\nposition_mm = [0, 0, 0]\nrotation_rad = [0, 0, 1]\n", "")
          .value();
  EXPECT_EQ(t.kind, TargetKind::kAprilTag);
  EXPECT_EQ(t.family, "tag36h11");
  ASSERT_EQ(t.tags.size(), 1U);
  EXPECT_EQ(t.tags[0].size_mm, 40.0);
  EXPECT_EQ(t.tags[0].rotation_rad, Vec3::UnitZ());
}

std::string tag(int id, const std::string& position, const std::string& more = "",
                const std::string& rotation = "[0, 0, 0]", double size_mm = 40.0) {
  return "[[tags]]\nid = " + std::to_string(id) + "\nsize_mm = " + std::to_string(size_mm) +
         "\nposition_mm = " + position + "\nrotation_rad = " + rotation + "\n" + more;
}

// Quarter turns about x and y: the faces of a cube of 50 mm whose edge faces the cameras.
TEST(TargetFileTest, TagsOnFacesOfACubeAreApart) {
  EXPECT_EQ(message_of(kTags + tag(0, "[0, 0, -25]") + tag(1, "[25, 0, 0]", "", "[0, -1.5707963, 0]") +
                       tag(2, "[0, 25, 0]", "", "[1.5707963, 0, 0]")),
            "");
}

TEST(TargetFileTest, TagsThatOverlapAreRefusedWithLineAndBothIds) {
  // beside each other, touching, is apart; an eighth of a turn needs 0.71 of a size more room
  EXPECT_EQ(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[40, 0, 0]")), "");
  EXPECT_THAT(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[39.9, 0, 0]")), HasSubstr("tag 0 and tag 1 do"));
  EXPECT_THAT(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[39.9, 0, 0]")), HasSubstr(":12: "));
  EXPECT_THAT(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[48, 0, 0]", "", "[0, 0, 0.785398]")),
              HasSubstr("overlap"));
  EXPECT_EQ(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[48.5, 0, 0]", "", "[0, 0, 0.785398]")), "");
}

TEST(TargetFileTest, ATagBeforeAnotherOverlapsAndBackToBackDoesNot) {
  EXPECT_THAT(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[10, 0, 5]")), HasSubstr("overlap"));
  EXPECT_EQ(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[10, 0, 1]", "", "[3.1415926, 0, 0]")), "");
}

TEST(TargetFileTest, TagsThatCutThroughEachOtherOverlap) {
  EXPECT_THAT(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[10, 0, 0]", "", "[0, 1.5707963, 0]")),
              HasSubstr("overlap"));
  EXPECT_EQ(message_of(kTags + tag(0, "[0, 0, 0]") + tag(1, "[21, 0, 0]", "", "[0, 1.5707963, 0]")), "");
}

// 706 mm are 998 mm along the diagonal; with 500 mm between their centres, tags of 40 mm reach 541.5 mm.
TEST(TargetFileTest, NoTwoCornersOfTagsAreAMetreApart) {
  const std::string none = "[0, 0, 0]";
  EXPECT_EQ(message_of(kTags + tag(0, none, "", none, 706.0)), "");
  EXPECT_THAT(message_of(kTags + tag(0, none, "", none, 708.0)), HasSubstr("size_mm"));
  EXPECT_THAT(message_of(kTags + tag(0, none, "", none, 708.0)), HasSubstr("less than 1000 mm from corner to corner"));
  EXPECT_THAT(message_of(kTags + tag(0, none, "", none, 9'000.0)), HasSubstr("size_mm"));
  EXPECT_EQ(message_of(kTags + tag(0, none) + tag(1, "[959, 0, 0]")), "");
  EXPECT_THAT(message_of(kTags + tag(0, none) + tag(1, "[960, 0, 0]")), HasSubstr("less than 1000 mm"));
}

TEST(TargetFileTest, EachTagIsThereOnce) {
  EXPECT_THAT(message_of(kTags + tag(4, "[0, 0, 0]") + tag(4, "[50, 0, 0]")), HasSubstr("each id once"));
}

TEST(TargetFileTest, TheUncertaintyOfATagsCornersIsReadAndItNeedsNoFacing) {
  EXPECT_EQ(parse_target(kTags + tag(0, "[0, 0, 0]", "uncertainty_mm = 0.2\n"), "")->tags[0].uncertainty_mm, 0.2);
  EXPECT_EQ(parse_target(kTags + tag(0, "[0, 0, 0]"), "")->tags[0].uncertainty_mm, 0.05);
  EXPECT_THAT(message_of(kTags + "facing = [0, 0, 1]\n" + tag(0, "[0, 0, 0]")), HasSubstr("unknown key facing"));
}

TEST(TargetFileTest, PointsDoNotBelongToATargetOfTags) {
  EXPECT_THAT(message_of(kTags + "[[tags]]\nid = 0\nsize_mm = 40\nposition_mm = [0, 0, 0]\nrotation_rad = [0, 0, 0]\n" +
                         point(1, "[0, 0, 0]")),
              HasSubstr("unknown key points"));
}

TEST(TargetFileTest, UnknownDetectorsFormatsAndKeysAreErrors) {
  EXPECT_THAT(message_of("format = \"tripoint-target/2\"\ndetector = \"led\"\n"), HasSubstr("\"tripoint-target/1\""));
  EXPECT_THAT(message_of("format = \"tripoint-target/1\"\ndetector = \"laser\"\n"),
              HasSubstr("\"led\" or \"apriltag\""));
  EXPECT_THAT(message_of(kHead + point(1, "[0, 0, 0]") + "posiion_mm = 1\n"), HasSubstr("did you mean position_mm?"));
}

TEST(TargetFileTest, TheSingleLedSitsAtTheOrigin) {
  const TargetFile t = single_led();
  ASSERT_EQ(t.points.size(), 1U);
  EXPECT_EQ(t.points[0].id, 1);
  EXPECT_EQ(t.points[0].position_mm, Vec3::Zero());
}

TEST(TargetFileTest, AMissingFileCannotBeRead) {
  EXPECT_EQ(load_target("/nowhere/t.toml").error().code, ErrorCode::kCannotRead);
}

}  // namespace
}  // namespace tripoint
