#include "config/edited_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "document/file.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kWritten = R"(# unit 7
[cameras]  # both
source = "simulation"
  exposure_us  =  2_000   # dark
[volume]
min_mm = [-150, -150, 300]  # exposure_us = 5
max_mm = [150, 150, 600]
)";
const std::array<ConfigEdit, 2> kEdits{{{"cameras", "exposure_us", 1234}, {"cameras", "gain", 7}}};

std::string edited(std::string_view text) {
  const Result<std::string> result = edited_config(text, "unit.toml", kEdits);
  return result ? *result : "error: " + result.error().message;
}

TEST(EditedConfigTest, OnlyTheValuesChangeAndAMissingKeyIsAddedBelowTheHeading) {
  EXPECT_EQ(edited(kWritten), R"(# unit 7
[cameras]  # both
gain = 7
source = "simulation"
  exposure_us  =  1234   # dark
[volume]
min_mm = [-150, -150, 300]  # exposure_us = 5
max_mm = [150, 150, 600]
)");
}

TEST(EditedConfigTest, AValueThatHoldsAlreadyIsNotWritten) {
  const std::array<ConfigEdit, 2> edits{{{"cameras", "exposure_us", 2000}, {"cameras", "gain", 0}}};
  EXPECT_EQ(edited_config(kWritten, "unit.toml", edits).value(), kWritten);
}

TEST(EditedConfigTest, LineEndsAndAMissingLastOneStay) {
  const std::string text =
      "[volume]\r\nmin_mm = [0, 0, 300]\r\nmax_mm = [1, 1, 600]\r\n[cameras]\r\nsource = \"simulation\"\r\ngain = "
      "1\r\nexposure_us = 2000";
  EXPECT_EQ(
      edited(text),
      "[volume]\r\nmin_mm = [0, 0, 300]\r\nmax_mm = [1, 1, 600]\r\n[cameras]\r\nsource = \"simulation\"\r\ngain = "
      "7\r\nexposure_us = 1234");
}

TEST(EditedConfigTest, ADottedKeyIsChangedWhereItStands) {
  const std::string text =
      "cameras.source = \"simulation\"\ncameras.gain = 1\ncameras.exposure_us = 9\n"
      "volume.min_mm = [0, 0, 300]\nvolume.max_mm = [1, 1, 600]\n";
  EXPECT_THAT(edited(text), HasSubstr("\ncameras.gain = 7\ncameras.exposure_us = 1234\n"));
}

TEST(EditedConfigTest, ATableWithoutAHeadingIsLeftToPeople) {
  const std::string text =
      "cameras = { source = \"simulation\", exposure_us = 9 }\n[volume]\nmin_mm = [0, 0, 300]\nmax_mm = [1, 1, 600]\n";
  EXPECT_THAT(edited(text), HasSubstr("write exposure_us = 1234 there yourself"));
}

TEST(EditedConfigTest, ATableThatOnlyItsSubtablesImplyIsAddedAtTheEnd) {
  const std::string text =
      "[cameras.left]  # [cameras]\nport = \"1-1\"\n[cameras.right]\nport = \"1-2\"\n"
      "[volume]\nmin_mm = [0, 0, 300]\nmax_mm = [1, 1, 600]";
  EXPECT_EQ(edited(text), text + "\n\n[cameras]\ngain = 7\nexposure_us = 1234\n");
}

const std::array<ConfigEdit, 2> kCalibrating{
    {{"cameras.calibrating", "exposure_us", 9000}, {"cameras.calibrating", "gain", 3}}};

std::string edited_for_calibrating(std::string_view text) {
  const Result<std::string> result = edited_config(text, "unit.toml", kCalibrating);
  return result ? *result : "error: " + result.error().message;
}

TEST(EditedConfigTest, ATableThatIsMissingIsAddedAndNothingElseChanges) {
  EXPECT_EQ(edited_for_calibrating(kWritten),
            std::string(kWritten) + "\n[cameras.calibrating]\ngain = 3\nexposure_us = 9000\n");
}

TEST(EditedConfigTest, ASubtableIsFoundHoweverItIsWritten) {
  const std::string with_heading =
      std::string(kWritten) + "[ cameras . calibrating ]  # board\nexposure_us = 5  # bright\n";
  EXPECT_EQ(edited_for_calibrating(with_heading),
            std::string(kWritten) + "[ cameras . calibrating ]  # board\ngain = 3\nexposure_us = 9000  # bright\n");
  const std::string dotted =
      "[cameras]\nsource = \"simulation\"\nexposure_us = 2\ncalibrating.exposure_us = 5\ncalibrating.gain = 1\n"
      "[volume]\nmin_mm = [0, 0, 300]\nmax_mm = [1, 1, 600]\n";
  EXPECT_THAT(edited_for_calibrating(dotted),
              HasSubstr("exposure_us = 2\ncalibrating.exposure_us = 9000\ncalibrating.gain = 3\n"));
}

TEST(EditedConfigTest, ASubtableInBracesIsLeftToPeople) {
  const std::string text =
      "[cameras]\nsource = \"simulation\"\ncalibrating = { exposure_us = 5 }\n"
      "[volume]\nmin_mm = [0, 0, 300]\nmax_mm = [1, 1, 600]\n";
  EXPECT_THAT(edited_for_calibrating(text),
              HasSubstr("cameras.calibrating.exposure_us cannot be changed without changing more: write exposure_us = "
                        "9000 there yourself"));
}

TEST(EditedConfigTest, AValueThatTheConfigurationRefusesIsRefused) {
  const std::array<ConfigEdit, 1> edits{{{"cameras", "exposure_us", 2'000'000}}};
  const Result<std::string> result = edited_config(kWritten, "unit.toml", edits);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kOutOfRange);
}

class EditedFileTest : public ::testing::Test {
 protected:
  EditedFileTest() { EXPECT_TRUE(write_file_whole(file_, kWritten)); }

  [[nodiscard]] std::string content() const { return read_file(file_, 10'000).value(); }

  test::ScratchFolder folder_;
  std::filesystem::path file_ = folder_ / "unit.toml";
};

TEST_F(EditedFileTest, PermissionsAndLinksStay) {
  using std::filesystem::perms;
  std::filesystem::permissions(file_, perms::owner_read | perms::owner_write);
  std::filesystem::create_symlink("unit.toml", folder_ / "link.toml");
  ASSERT_TRUE(edit_config_file(folder_ / "link.toml", kEdits));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.toml"));
  EXPECT_EQ(content(), edited(kWritten));
  EXPECT_EQ(std::filesystem::status(file_).permissions(), perms::owner_read | perms::owner_write);
}

TEST_F(EditedFileTest, AReadOnlyFileStaysAsItIs) {
  std::filesystem::permissions(file_, std::filesystem::perms::owner_read);
  const Result<void> refused = edit_config_file(file_, kEdits);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(content(), kWritten);
}

TEST_F(EditedFileTest, AMissingFileIsNamed) {
  const Result<void> refused = edit_config_file(folder_ / "none.toml", kEdits);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kCannotRead);
  EXPECT_THAT(refused.error().message, HasSubstr("none.toml"));
}

TEST(EditedConfigTest, TheLinesToPasteNameTheirTableOnce) {
  EXPECT_EQ(lines_of(kEdits), "[cameras]\nexposure_us = 1234\ngain = 7\n");
}

}  // namespace
}  // namespace tripoint
