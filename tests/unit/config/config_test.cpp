#include "config/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config_text.h"
#include "document/sha256.h"

namespace tripoint {
namespace {

using testing::config_with;
using ::testing::HasSubstr;
using testing::kSmallest;
using testing::message_of;
using testing::message_with;
using ::testing::Not;

TEST(ConfigTest, TheSmallestConfigurationHasTheDocumentedDefaults) {
  const Config c = config_with({}).value();
  EXPECT_EQ(c.cameras.format, ConfiguredFormat::kYuyv);
  EXPECT_EQ(c.cameras.size, (ImageSize{640, 480}));
  EXPECT_EQ(c.cameras.rate_hz, 30.0);
  EXPECT_EQ(c.cameras.measuring.exposure, std::chrono::microseconds{2000});
  EXPECT_EQ(c.cameras.loss_after, std::chrono::milliseconds{100});
  EXPECT_TRUE(c.calibration_file.empty());
  EXPECT_TRUE(c.target_file.empty());
  EXPECT_EQ(c.timing.offset_prior_ms, 10.0);
  EXPECT_EQ(c.timing.bound_mm, 1.0);
  EXPECT_EQ(c.output.frame, ConfiguredFrame::kReference);
  EXPECT_EQ(c.output.method, ConfiguredMethod::kMaximumLikelihood);
  EXPECT_EQ(c.output.age_limit, std::chrono::milliseconds{200});
  EXPECT_EQ(c.output.latch_hold, std::chrono::seconds{10});
  EXPECT_EQ(c.modbus.address, "127.0.0.1");
  EXPECT_EQ(c.modbus.port, 1502);
  EXPECT_TRUE(c.modbus.command_clients.empty());
  EXPECT_EQ(c.modbus.max_connections, 64);
  EXPECT_EQ(c.simulation.seed, 1U);
}

TEST(ConfigTest, TheWorkingVolumeIsRequired) {
  EXPECT_EQ(message_of("[cameras]\nsource = \"simulation\"\n"),
            "demo.toml:1: volume.min_mm is missing: permitted is 3 numbers from -100000 to 100000");
}

TEST(ConfigTest, AnUnknownTableIsAnErrorWithTheNearestName) {
  const auto config = parse_config(std::string{kSmallest} + "[simulaton]\n", "demo.toml", {});
  ASSERT_FALSE(config.has_value());
  EXPECT_EQ(config.error().code, ErrorCode::kUnknownKey);
  EXPECT_EQ(config.error().message, "demo.toml:6: unknown key simulaton (did you mean simulation?)");
}

TEST(ConfigTest, AnUnknownKeyIsAnErrorInEveryTable) {
  for (const char* table : {"cameras", "cameras.left", "cameras.right", "calibration", "recording", "detector",
                            "target", "volume", "datum", "timing", "output", "modulation", "modbus", "simulation"}) {
    const auto config = config_with({std::string{table} + ".nonsense=1"});
    ASSERT_FALSE(config.has_value()) << table;
    EXPECT_EQ(config.error().code, ErrorCode::kUnknownKey);
    EXPECT_THAT(config.error().message, HasSubstr(std::string{table} + ".nonsense"));
  }
}

TEST(ConfigTest, TablesOfFeaturesThatDoNotExistAreErrors) {
  EXPECT_THAT(message_with({"registration.file=r.toml"}), HasSubstr("unknown key registration"));
}

TEST(ConfigTest, TextThatIsNotTomlNamesItsLine) {
  EXPECT_THAT(message_of("[cameras]\nsource = \n"), HasSubstr("demo.toml:2"));
}

TEST(ConfigTest, ALoneDateNamesItsLine) {
  EXPECT_THAT(message_of("[output]\nage_limit_ms = 2026-01-31\n"), HasSubstr("demo.toml:2: a date or time alone"));
}

TEST(ConfigTest, AnErrorOfANamedFileIsToldWithThePlaceThatNamesIt) {
  const Error inner{ErrorCode::kCannotRead, "cal.toml: cannot open"};
  const auto written = parse_config(std::string{kSmallest} + "[calibration]\nfile = \"cal.toml\"\n", "demo.toml", {});
  EXPECT_EQ(named_by(*written, "calibration.file", inner).message,
            "demo.toml:7: calibration.file: cal.toml: cannot open");
  EXPECT_EQ(named_by(*config_with({"calibration.file=cal.toml"}), "calibration.file", inner).message,
            "/etc/tripoint/demo.toml with --set: calibration.file: cal.toml: cannot open");
  EXPECT_EQ(named_by(*config_with({}), "target.file", inner).message, "target.file: cal.toml: cannot open");
}

TEST(ConfigTest, OverridesCountMoreThanTheFile) {
  EXPECT_EQ(config_with({"modbus.port=1503", "modbus.port=1504"})->modbus.port, 1504);
}

TEST(ConfigTest, OverridesAreCheckedLikeTheFile) {
  EXPECT_EQ(message_with({"modbus.port=0"}),
            "/etc/tripoint/demo.toml with --set: modbus.port = 0: permitted is a whole number from 1 to 65535");
  EXPECT_THAT(message_with({"modbus.port"}), HasSubstr("table.key=value"));
}

TEST(ConfigTest, RelativePathsAreRelativeToTheFile) {
  const Config c = config_with({"calibration.file=rig/../c.toml", "target.file=/opt/t.toml"}).value();
  EXPECT_EQ(c.calibration_file, "/etc/tripoint/c.toml");
  EXPECT_EQ(c.target_file, "/opt/t.toml");
}

TEST(ConfigTest, TheIdIsThatOfTheValuesNotOfTheWriting) {
  const std::uint32_t id = config_with({})->id;
  EXPECT_NE(id, 0U);
  EXPECT_EQ(config_with({"cameras.rate_hz=30"})->id, id);
  EXPECT_EQ(parse_config("# a comment\n" + std::string{kSmallest}, "elsewhere/x.toml", {})->id, id);
  EXPECT_NE(config_with({"cameras.rate_hz=31"})->id, id);
  EXPECT_NE(config_with({"modbus.port=1503"})->id, id);
}

TEST(ConfigTest, TheSetupTextHoldsTheTablesThatChangeWhatIsMeasured) {
  const std::string text = canonical_text(config_with({}).value(), kSetupTables);
  EXPECT_THAT(text, HasSubstr("cameras.source = simulation\n"));
  EXPECT_THAT(text, HasSubstr("cameras.left.serial = \n"));
  EXPECT_THAT(text, HasSubstr("detector.kind = led\n"));
  EXPECT_THAT(text, HasSubstr("timing.bound_mm = 1\n"));
  EXPECT_THAT(text, HasSubstr("output.method = maximum_likelihood\n"));
  EXPECT_THAT(text, Not(HasSubstr("modbus")));
}

TEST(ConfigTest, OnlyWhatChangesTheMeasurementChangesTheSetupText) {
  const std::string text = canonical_text(config_with({}).value(), kSetupTables);
  EXPECT_EQ(canonical_text(config_with({"modbus.port=1503"}).value(), kSetupTables), text);
  EXPECT_EQ(canonical_text(config_with({"cameras.calibrating.exposure_us=9000"}).value(), kSetupTables), text);
  EXPECT_NE(canonical_text(config_with({"cameras.exposure_us=9000"}).value(), kSetupTables), text);
  EXPECT_NE(canonical_text(config_with({"output.method=paper"}).value(), kSetupTables), text);
  EXPECT_NE(canonical_text(config_with({"cameras.left.port=1-1"}).value(), kSetupTables), text);
}

TEST(ConfigTest, AMissingFileCannotBeRead) {
  EXPECT_EQ(load_config("/nowhere/demo.toml", {}).error().code, ErrorCode::kCannotRead);
}

}  // namespace
}  // namespace tripoint
