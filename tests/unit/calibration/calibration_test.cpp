#include "calibration/calibration.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration_text.h"

namespace tripoint {
namespace {

using ::testing::HasSubstr;
using testing::kCalibration;
using ::testing::StartsWith;
using testing::with;

Error error_of(const std::string& text) {
  const Result<Calibration> calibration = parse_calibration(text, "c.toml");
  EXPECT_FALSE(calibration.has_value()) << text;
  return calibration ? Error{ErrorCode::kTimeout, ""} : calibration.error();
}

std::string message_of(const std::string& text) { return error_of(text).message; }

TEST(CalibrationTest, TheDocumentedFileIsRead) {
  const Calibration c = parse_calibration(kCalibration, "c.toml").value();
  EXPECT_EQ(c.stereo.cameras.left.size, (ImageSize{640, 480}));
  EXPECT_EQ(c.stereo.cameras.right.size, (ImageSize{320, 240}));
  EXPECT_EQ(c.stereo.cameras.left.focal_px, Vec2(628.0, 628.6));
  EXPECT_EQ(c.stereo.cameras.right.center_px, Vec2(317.1, 243.5));
  EXPECT_EQ(c.stereo.cameras.left.distortion, (std::array<double, 5>{-0.30, 0.10, 5e-4, -3e-4, 0.0}));
  EXPECT_EQ(c.stereo.right_from_left.translation(), Vec3(-99.6, 0.2, 8.7));
  EXPECT_EQ(c.serial.left, "LEFT-001");
  EXPECT_EQ(c.serial.right, "");
  EXPECT_EQ(c.port.right, "1-2");
  EXPECT_FALSE(c.covariance.has_value());
  EXPECT_EQ(c.created, UtcSecond{std::chrono::seconds{1795348800}});  // date -u -d 2026-11-22T12:00:00Z +%s
}

TEST(CalibrationTest, TheRotationVectorTurnsByItsLengthAboutItself) {
  const Vec3 vector{0.00698, 0.17453, 0.01222};
  const Matrix3 rotation = parse_calibration(kCalibration, "")->stereo.right_from_left.linear();
  EXPECT_NEAR((rotation * vector - vector).norm(), 0.0, 1e-15);
  EXPECT_NEAR(std::acos(0.5 * (rotation.trace() - 1.0)), vector.norm(), 1e-14);
  EXPECT_GT(rotation(0, 2), 0.0);  // right-handed: about +y, z moves towards +x
}

TEST(CalibrationTest, TheIdIsTheStartOfTheHashOfTheWholeFile) {
  const Calibration c = parse_calibration(kCalibration, "").value();
  EXPECT_EQ(c.sha256, sha256(kCalibration));
  EXPECT_EQ(c.id, id_from(c.sha256));
  EXPECT_NE(parse_calibration(with("rms_px = 0.07", "rms_px = 0.08"), "")->id, c.id);
}

TEST(CalibrationTest, WhatOthersMayLeaveOutIsOptional) {
  std::string text = with("created = 2026-11-22T12:00:00Z\nverified = true\n", "");
  text = with("serial = \"LEFT-001\"\nport = \"1-1\"\n", "", text);
  text.erase(text.find("[quality]"));
  const Calibration c = parse_calibration(text, "").value();
  EXPECT_FALSE(c.created.has_value());
  EXPECT_EQ(c.serial.left, "");
  EXPECT_FALSE(verified_by_length(c));
}

TEST(CalibrationTest, ALengthWithinItsUncertaintyVerifies) {
  EXPECT_TRUE(verified_by_length(parse_calibration(kCalibration, "").value()));
  EXPECT_TRUE(verified_by_length(parse_calibration(with("200.03", "200.0499"), "").value()));
  EXPECT_TRUE(verified_by_length(parse_calibration(with("200.03", "199.9501"), "").value()));
}

TEST(CalibrationTest, ALengthOutsideItsUncertaintyDoesNotVerify) {
  EXPECT_FALSE(verified_by_length(parse_calibration(with("200.03", "200.0501"), "").value()));
  EXPECT_FALSE(verified_by_length(parse_calibration(with("200.03", "199.9499"), "").value()));
}

TEST(CalibrationTest, OneBadLengthAmongGoodOnesDoesNotVerify) {
  const std::string second = "[[quality.lengths]]\nnominal_mm = 100.0\nmeasured_mm = 101.0\nuncertainty_mm = 0.05\n";
  const Calibration c = parse_calibration(std::string{kCalibration} + second, "").value();
  EXPECT_EQ(c.lengths.size(), 2U);
  EXPECT_FALSE(verified_by_length(c));
}

TEST(CalibrationTest, ALengthKnownOnlyRoughlyDoesNotVerify) {
  EXPECT_TRUE(verified_by_length(parse_calibration(with("mm = 0.05", "mm = 2.0"), "").value()));
  EXPECT_FALSE(verified_by_length(parse_calibration(with("mm = 0.05", "mm = 2.1"), "").value()));
}

TEST(CalibrationTest, TheFilesOwnWordDoesNotVerify) {
  std::string text{kCalibration};
  text.erase(text.find("[quality]"));
  EXPECT_FALSE(verified_by_length(parse_calibration(text, "").value()));
}

TEST(CalibrationTest, AnotherFormatIsAnError) {
  EXPECT_THAT(message_of(with("calibration/1", "calibration/2")), HasSubstr("permitted is \"tripoint-calibration/1\""));
}

TEST(CalibrationTest, TextThatIsNotTomlIsMalformed) { EXPECT_EQ(error_of("[cameras").code, ErrorCode::kMalformed); }

TEST(CalibrationTest, EachRequiredKeyIsMissed) {
  for (const char* key : {"format", "width_px", "height_px", "focal_px", "center_px", "distortion", "rotation_rad",
                          "translation_mm", "nominal_mm", "measured_mm", "uncertainty_mm"}) {
    std::string text{kCalibration};
    const std::size_t at = text.find(std::string{key} + " = ");
    text.erase(at, text.find('\n', at) + 1 - at);
    const Error error = error_of(text);
    EXPECT_EQ(error.code, ErrorCode::kMissingKey) << key;
    EXPECT_THAT(error.message, HasSubstr(std::string{key} + " is missing"));
  }
}

TEST(CalibrationTest, UnknownKeysAreErrorsEverywhereButInQuality) {
  for (const char* place : {"[cameras.left]\n", "[right_from_left]\n", "[[quality.lengths]]\n"}) {
    const Error error = error_of(with(place, std::string{place} + "focal = 1\n"));
    EXPECT_EQ(error.code, ErrorCode::kUnknownKey);
    EXPECT_THAT(error.message, HasSubstr("focal"));
  }
  EXPECT_EQ(error_of("extra = 1\n" + std::string{kCalibration}).code, ErrorCode::kUnknownKey);
  EXPECT_EQ(error_of(std::string{kCalibration} + "[cameras.middle]\n").code, ErrorCode::kUnknownKey);
  EXPECT_TRUE(parse_calibration(with("rms_px", "anything"), "").has_value());
}

TEST(CalibrationTest, AnErrorNamesFileLineKeyAndRange) {
  EXPECT_EQ(message_of(with("width_px = 640", "width_px = 15")),
            "c.toml:7: cameras.left.width_px = 15: permitted is a whole number from 16 to 8192");
}

TEST(CalibrationTest, TheSizesRangeIncludesItsEnds) {
  EXPECT_TRUE(parse_calibration(with("width_px = 640", "width_px = 16"), "").has_value());
  EXPECT_TRUE(parse_calibration(with("width_px = 640", "width_px = 8192"), "").has_value());
  EXPECT_EQ(error_of(with("width_px = 640", "width_px = 8193")).code, ErrorCode::kOutOfRange);
}

TEST(CalibrationTest, ValuesThatNoCameraHasAreErrors) {
  EXPECT_EQ(error_of(with("[628.0, 628.6]", "[0.0, 628.6]")).code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error_of(with("[628.0, 628.6]", "[628.0, -628.6]")).code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error_of(with("[628.0, 628.6]", "[628.0]")).code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error_of(with("[322.3, 237.8]", "[nan, 237.8]")).code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error_of(with("[-0.30, 0.10,", "[inf, 0.10,")).code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error_of(with("[0.00698,", "[3.2,")).code, ErrorCode::kOutOfRange);
}

TEST(CalibrationTest, CamerasWithoutABaselineAreAnError) {
  EXPECT_THAT(message_of(with("[-99.6, 0.2, 8.7]", "[0.0, 0.0, 0.0]")),
              HasSubstr("right_from_left: the lens centres coincide; permitted is"));
}

TEST(CalibrationTest, ACovarianceIsReadRowByRow) {
  std::string rows;
  for (int i = 0; i < 576; ++i) {
    // Variance 4 for the first and 9 for the second parameter, covariance 1 between them, 1 for the rest.
    const int row = i / 24;
    const int column = i % 24;
    const int value = row == column ? (row == 0 ? 4 : row == 1 ? 9 : 1) : (row + column == 1 ? 1 : 0);
    rows += std::to_string(value) + ",";
  }
  const Calibration c =
      parse_calibration(with("[quality]", "[covariance]\nmatrix = [" + rows + "]\n[quality]"), "").value();
  ASSERT_TRUE(c.covariance.has_value());
  EXPECT_EQ((*c.covariance)(0, 0), 4.0);
  EXPECT_EQ((*c.covariance)(1, 1), 9.0);
  EXPECT_EQ((*c.covariance)(0, 1), 1.0);
  EXPECT_EQ((*c.covariance)(23, 23), 1.0);
}

TEST(CalibrationTest, ACovarianceOfAnotherSizeOrMeaningIsAnError) {
  EXPECT_THAT(message_of(with("[quality]", "[covariance]\nmatrix = [1, 2]\n[quality]")), HasSubstr("576 numbers"));
  std::string negative = "-1";
  for (int i = 1; i < 576; ++i) negative += ",0";
  EXPECT_THAT(message_of(with("[quality]", "[covariance]\nmatrix = [" + negative + "]\n[quality]")),
              HasSubstr("row 1: variance -1"));
}

TEST(CalibrationTest, AMissingFileCannotBeRead) {
  EXPECT_EQ(load_calibration("/nowhere/c.toml").error().code, ErrorCode::kCannotRead);
}

}  // namespace
}  // namespace tripoint
