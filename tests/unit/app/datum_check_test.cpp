#include "app/datum_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/unit_setup.h"
#include "places.h"

namespace tripoint {
namespace {

using ::testing::HasSubstr;

/// "" when the demo would start with a datum there; its volume reaches 200 mm to each side and from 250 to 600 mm.
std::string message_of(const std::string& position_mm, std::vector<std::string> overrides = {}) {
  overrides.push_back("datum.position_mm=" + position_mm);
  overrides.emplace_back("datum.uncertainty_mm=0.2");
  overrides.emplace_back("datum.radius_mm=10");
  const auto setup = load_config(test::top_folder() / "deploy/demo/demo.toml", overrides).and_then(unit_setup);
  return setup ? "" : setup.error().message;
}

TEST(DatumCheckTest, OutsideTheVolumeByItsRadiusItIsAccepted) {
  EXPECT_EQ(message_of("[20, 30, 610]"), "");
  EXPECT_THAT(message_of("[20, 30, 609.9]"),
              HasSubstr("datum.position_mm: 9.9 mm outside [volume], less than datum.radius_mm = 10"));
  EXPECT_THAT(message_of("[20, 30, 400]"), HasSubstr("0.0 mm outside [volume]"));
}

TEST(DatumCheckTest, TheVolumeIsAskedAlsoWithoutACalibration) {
  EXPECT_THAT(message_of("[20, 30, 400]", {"calibration.file="}), HasSubstr("outside [volume]"));
  EXPECT_EQ(message_of("[20, 30, -610]", {"calibration.file="}), "");
}

TEST(DatumCheckTest, ItsPlaceIsInTheReferenceFrameWhateverTheOutputFrame) {
  // The left camera stands 50 mm to the left and looks 5 degrees to the right: 300 mm away x is 24 mm more for it.
  const std::string wide = "volume.max_mm=[100, 200, 700]";
  EXPECT_THAT(message_of("[95, 30, 300]", {wide}), HasSubstr("0.0 mm outside [volume]"));
  EXPECT_EQ(message_of("[95, 30, 300]", {wide, "output.frame=left_camera"}), "");
}

TEST(DatumCheckTest, BothCamerasMustSeeIt) {
  EXPECT_THAT(message_of("[0, 0, -400]"), HasSubstr("not in front of the left camera"));
  EXPECT_THAT(message_of("[0, 400, 700]"), HasSubstr("inside its picture of 640 x 480 px"));
  EXPECT_THAT(message_of("[-380, 0, 700]"), HasSubstr("seen by the left camera"));
  EXPECT_THAT(message_of("[380, 0, 700]"), HasSubstr("seen by the right camera"));
}

TEST(DatumCheckTest, TheSetupIsAnotherWithADatum) {
  const auto setup_with = [](const std::vector<std::string>& overrides) {
    return load_config(test::top_folder() / "deploy/demo/demo.toml", overrides)
        .and_then(unit_setup)
        ->constants.identity.setup;
  };
  const std::vector<std::string> datum{"datum.position_mm=[20, 30, 650]", "datum.uncertainty_mm=0.2",
                                       "datum.radius_mm=10"};
  std::vector<std::string> moved = datum;
  moved.emplace_back("datum.position_mm=[20, 31, 650]");
  EXPECT_NE(setup_with({}), setup_with(datum));
  EXPECT_NE(setup_with(datum), setup_with(moved));
}

}  // namespace
}  // namespace tripoint
