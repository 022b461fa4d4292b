#include "calibration/integrity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/calibration.h"
#include "calibration_text.h"
#include "document/sha256.h"

namespace tripoint {
namespace {

using ::testing::HasSubstr;
using testing::kCalibration;

std::string sealed(const std::string& text, const std::string& header = "[integrity]\n") {
  return text + header + "sha256 = \"" + hex_from(sha256(text)) + "\"\n";
}

std::string message_of(const std::string& text) {
  const Result<Calibration> calibration = parse_calibration(text, "c.toml");
  return calibration ? "" : calibration.error().message;
}

TEST(IntegrityTest, ASealedFileIsAccepted) { EXPECT_EQ(message_of(sealed(std::string{kCalibration})), ""); }

TEST(IntegrityTest, AFileWithoutASealIsAccepted) { EXPECT_EQ(message_of(std::string{kCalibration}), ""); }

TEST(IntegrityTest, EveryFlippedDigitIsNoticed) {
  const std::string text = sealed(std::string{kCalibration});
  const std::size_t end = text.find("[integrity]");
  int flipped = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (text[i] < '0' || text[i] > '9') continue;
    std::string damaged = text;
    damaged[i] = damaged[i] == '9' ? '8' : static_cast<char>(damaged[i] + 1);
    EXPECT_NE(message_of(damaged), "") << "byte " << i;
    ++flipped;
  }
  EXPECT_GT(flipped, 100);
}

TEST(IntegrityTest, DamageSaysWhatToDo) {
  std::string text = sealed(std::string{kCalibration});
  text[text.find("628.0") + 2] = '9';
  EXPECT_THAT(message_of(text), HasSubstr("damaged or was edited"));
}

TEST(IntegrityTest, ATableAfterTheSealIsRefused) {
  std::string text{kCalibration};
  const std::string tail = text.substr(text.find("[quality]"));
  text.erase(text.find("[quality]"));
  EXPECT_THAT(message_of(sealed(text) + tail), HasSubstr("permitted is the last table"));
  EXPECT_THAT(message_of(sealed(text) + "  " + tail), HasSubstr("permitted is the last table"));
}

TEST(IntegrityTest, AHeaderThatIsNotAloneOnItsLineIsRefused) {
  EXPECT_THAT(message_of(sealed(std::string{kCalibration}, "[ integrity ]\n")), HasSubstr("alone on a line"));
  EXPECT_THAT(message_of(sealed(std::string{kCalibration}, " [integrity]\n")), HasSubstr("alone on a line"));
}

TEST(IntegrityTest, ALineEndOfWindowsIsAccepted) {
  EXPECT_EQ(message_of(sealed(std::string{kCalibration}, "[integrity]\r\n")), "");
}

TEST(IntegrityTest, ASealWithoutItsHashIsRefused) {
  EXPECT_THAT(message_of(std::string{kCalibration} + "[integrity]\n"), HasSubstr("integrity.sha256 is missing"));
}

}  // namespace
}  // namespace tripoint
