#include "app/unit_setup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "places.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

Result<UnitSetup> demo_setup(const std::vector<std::string>& overrides = {}) {
  return load_config(test::top_folder() / "deploy/demo/demo.toml", overrides).and_then(unit_setup);
}

/// A file of one tag.
class TagTarget {
 public:
  explicit TagTarget(int id = 1, const std::string& family = "tag36h11") {
    std::ofstream(path()) << "format = \"tripoint-target/1\"\ndetector = \"apriltag\"\nfamily = \"" << family
                          << "\"\n[[tags]]\nid = " << id
                          << "\nsize_mm = 40\nposition_mm = [0, 0, 0]\nrotation_rad = [0, 0, 0]\n";
  }
  void add(int id, const std::string& position_mm) {
    std::ofstream(path(), std::ios::app) << "[[tags]]\nid = " << id << "\nsize_mm = 40\nposition_mm = " << position_mm
                                         << "\nrotation_rad = [0, 0, 0]\n";
  }
  [[nodiscard]] std::string path() const { return (folder_ / "tag.toml").string(); }

 private:
  test::ScratchFolder folder_;
};

CameraStatus camera(const std::string& serial, ImageSize size = {640, 480}) {
  CameraStatus status;
  status.delivering = true;
  status.info.serial = serial;
  status.info.size = size;
  return status;
}

TEST(UnitSetupTest, TheDemoIsACalibratedSimulation) {
  const Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_TRUE(setup->constants.calibrated);
  EXPECT_TRUE(setup->constants.simulated);
  EXPECT_NE(setup->constants.identity.setup, 0);
  EXPECT_NE(setup->constants.identity.calibration_id, 0U);
  ASSERT_NE(setup->model, nullptr);
  EXPECT_EQ(setup->model->target.points.size(), 3U);
  EXPECT_EQ(setup->constants.identity.mode, registers::Mode::kLedPose);
}

TEST(UnitSetupTest, WithoutACalibrationFileThereIsNoModel) {
  const Result<UnitSetup> setup = demo_setup({"calibration.file="});
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->model, nullptr);
  EXPECT_FALSE(setup->constants.calibrated);
  EXPECT_EQ(setup->constants.identity.calibration_id, 0U);
}

TEST(UnitSetupTest, AMissingCalibrationFileIsNamed) {
  const Result<UnitSetup> setup = demo_setup({"calibration.file=nowhere.toml"});
  ASSERT_FALSE(setup);
  EXPECT_NE(setup.error().message.find("nowhere.toml"), std::string::npos);
}

TEST(UnitSetupTest, ACalibrationOfAnotherPictureSizeIsRefusedWithBothSizes) {
  const Result<UnitSetup> setup = demo_setup({"cameras.width_px=320", "cameras.height_px=240"});
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, ErrorCode::kMismatch);
  EXPECT_NE(setup.error().message.find("calibration.file: made at 640x480"), std::string::npos);
  EXPECT_NE(setup.error().message.find("320x240"), std::string::npos);
}

TEST(UnitSetupTest, SpheresAreNotMeasuredAndTheRemedyIsSaid) {
  for (const char* calibration : {"calibration.file=calibration.toml", "calibration.file="}) {
    const Result<UnitSetup> setup = demo_setup({"detector.kind=sphere", calibration});
    ASSERT_FALSE(setup);
    EXPECT_EQ(setup.error().code, ErrorCode::kMismatch);
    EXPECT_NE(setup.error().message.find("detector.kind: \"sphere\""), std::string::npos) << setup.error().message;
    EXPECT_NE(setup.error().message.find("set \"led\""), std::string::npos) << setup.error().message;
  }
}

TEST(UnitSetupTest, ATargetOfTagsNeedsTheirDetectorAndTheOtherWayRound) {
  const TagTarget target;
  const std::string tags = "target.file=" + target.path();
  const Result<UnitSetup> setup = demo_setup({tags, "detector.kind=apriltag"});
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->constants.identity.mode, registers::Mode::kApriltagPose);
  ASSERT_EQ(setup->model->target.tags.size(), 1U);
  EXPECT_EQ(setup->model->target.tags[0].corners_mm[0], Vec3(-20.0, 20.0, 0.0));  // lower left, y down
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{tags}, {"detector.kind=apriltag"}}) {
    const Result<UnitSetup> refused = demo_setup(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kMismatch);
    EXPECT_NE(refused.error().message.find("target.file"), std::string::npos) << refused.error().message;
    EXPECT_NE(refused.error().message.find("detector.kind"), std::string::npos) << refused.error().message;
  }
}

// The longest side is 110 mm: 11 mm of width are a tenth.
TEST(UnitSetupTest, ThePapersMethodNeedsCentresThatMakeATriangle) {
  const auto message = [](const TagTarget& target, const std::string& method) {
    const Result<UnitSetup> setup =
        demo_setup({"target.file=" + target.path(), "detector.kind=apriltag", "output.method=" + method});
    return setup ? std::string{} : setup.error().message;
  };
  TagTarget target;
  target.add(2, "[110, 0, 0]");
  EXPECT_NE(message(target, "paper").find("target.file: output.method"), std::string::npos) << message(target, "paper");
  EXPECT_NE(message(target, "paper").find("fewer than three"), std::string::npos);
  EXPECT_EQ(message(target, "maximum_likelihood"), "");
  TagTarget wide;
  wide.add(2, "[110, 0, 0]");
  target.add(3, "[55, 10.9, 0]");
  wide.add(3, "[55, 11.1, 0]");
  EXPECT_NE(message(target, "paper").find("nearly on a line: set it to \"maximum_likelihood\""), std::string::npos)
      << message(target, "paper");
  EXPECT_EQ(message(target, "maximum_likelihood"), "");
  EXPECT_EQ(message(wide, "paper"), "");
}

TEST(UnitSetupTest, ATagThatItsFamilyDoesNotHaveIsNamedWithThoseItHas) {
  for (const auto& [family, id, said] : {std::tuple{"tag16h5", 30, "0 to 29"}, {"tag99", 1, "tagStandard41h12"}}) {
    const TagTarget target(id, family);
    const Result<UnitSetup> refused = demo_setup({"target.file=" + target.path(), "detector.kind=apriltag"});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    EXPECT_NE(refused.error().message.find(said), std::string::npos) << refused.error().message;
  }
}

TEST(UnitSetupTest, ModulationIsPartOfTheSetupAndNeedsATargetOfLeds) {
  const Result<UnitSetup> setup = demo_setup({"modulation.enabled=true"});
  ASSERT_TRUE(setup) << setup.error().message;
  ASSERT_EQ(setup->target.target.points.size(), 3U);
  EXPECT_EQ(setup->target.target.points[0].id, 1);
  EXPECT_NE(setup->constants.identity.setup, demo_setup()->constants.identity.setup);

  const TagTarget target;
  const std::string tags = "target.file=" + target.path();
  EXPECT_TRUE(demo_setup({"calibration.file=", tags, "detector.kind=apriltag"}));
  const Result<UnitSetup> refused = demo_setup({"calibration.file=", tags, "modulation.enabled=true"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kMismatch);
  EXPECT_NE(refused.error().message.find("target.file: the target is made of AprilTags"), std::string::npos)
      << refused.error().message;
}

TEST(UnitSetupTest, OneSteadyLedIsWarnedAboutBecauseAnotherRedLightCanStandInForIt) {
  const auto warned = [](const std::vector<std::string>& overrides) {
    const Result<UnitSetup> setup = demo_setup(overrides);
    EXPECT_TRUE(setup) << setup.error().message;
    return setup && setup->constants.warnings.contains(Warning::kLightUnproved);
  };
  EXPECT_FALSE(warned({}));  // three LEDs
  EXPECT_TRUE(warned({"target.file="}));
  EXPECT_FALSE(warned({"target.file=", "modulation.enabled=true"}));
  EXPECT_FALSE(warned({"target.file=" + TagTarget().path(), "detector.kind=apriltag"}));
}

TEST(UnitSetupTest, TheSetupChangesWithWhatAPoseMeansAndWithNothingElse) {
  const std::uint16_t setup = demo_setup()->constants.identity.setup;
  EXPECT_NE(demo_setup({"output.frame=left_camera"})->constants.identity.setup, setup);
  EXPECT_NE(demo_setup({"timing.offset_prior_ms=5"})->constants.identity.setup, setup);
  EXPECT_NE(demo_setup({"calibration.file="})->constants.identity.setup, setup);
  EXPECT_EQ(demo_setup({"modbus.port=1503"})->constants.identity.setup, setup);
}

TEST(UnitSetupTest, TheLeftCameraFrameTurnsPointsIntoIt) {
  const Result<UnitSetup> setup = demo_setup({"output.frame=left_camera"});
  ASSERT_TRUE(setup);
  const Isometry3& output_from_rig = setup->model->output_from_rig;
  EXPECT_TRUE(output_from_rig.isApprox(setup->model->rig.camera_from_rig.left));
}

TEST(FitsCalibrationTest, AnotherSerialOrSizeDoesNotFit) {
  const Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup);
  const CalibrationFits fits = fits_calibration(setup->calibration, CameraSource::kSimulation);
  EXPECT_TRUE(fits({camera("SIM-LEFT"), camera("SIM-RIGHT")}));
  EXPECT_FALSE(fits({camera("SIM-RIGHT"), camera("SIM-LEFT")}));
  EXPECT_FALSE(fits({camera("SIM-LEFT"), camera("SIM-RIGHT", {320, 240})}));
}

TEST(FitsCalibrationTest, ACameraThatDoesNotDeliverIsNotJudged) {
  const Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup);
  EXPECT_TRUE(fits_calibration(setup->calibration, CameraSource::kSimulation)({CameraStatus{}, camera("SIM-RIGHT")}));
}

TEST(FitsCalibrationTest, ACameraThatGoesAwayKeepsItsJudgement) {
  const Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup);
  const CalibrationFits fits = fits_calibration(setup->calibration, CameraSource::kSimulation);
  EXPECT_FALSE(fits({camera("OTHER"), camera("SIM-RIGHT")}));
  EXPECT_FALSE(fits({CameraStatus{}, camera("SIM-RIGHT")}));
}

TEST(FitsCalibrationTest, EqualSerialsAreToldApartByTheirPorts) {
  Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup);
  setup->calibration->serial = {"SN0001", "SN0001"};
  setup->calibration->port = {"1-1", "1-2"};
  CameraStatus left = camera("SN0001");
  CameraStatus right = camera("SN0001");
  left.info.port = "1-1";
  right.info.port = "1-2";
  EXPECT_TRUE(fits_calibration(setup->calibration, CameraSource::kV4l2)({left, right}));
  EXPECT_FALSE(fits_calibration(setup->calibration, CameraSource::kV4l2)({right, left}));
}

TEST(FitsCalibrationTest, ARecordingIsJudgedByItsSizeAlone) {
  const Result<UnitSetup> setup = demo_setup();
  ASSERT_TRUE(setup);
  const CalibrationFits fits = fits_calibration(setup->calibration, CameraSource::kRecording);
  EXPECT_TRUE(fits({camera(""), camera("")}));
  EXPECT_FALSE(fits({camera("", {320, 240}), camera("")}));
}

}  // namespace
}  // namespace tripoint
