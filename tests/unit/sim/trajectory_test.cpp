#include "sim/trajectory.h"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "scratch_folder.h"

namespace tripoint {
namespace {

constexpr double kRounding_mm = 1e-9;

Vec3 place_at(const Trajectory& trajectory, double t_s) {
  return target_pose_at(trajectory, duration_from_seconds(t_s)).translation();
}

Result<Trajectory> loaded_from(const std::string& text) {
  const test::ScratchFolder folder;
  const std::filesystem::path path = folder / "motion.csv";
  std::ofstream(path) << text;
  return load_trajectory(path);
}

TEST(TrajectoryTest, PaperLineGoesFortyHundredTenInSixSecondsAndBack) {
  const Trajectory line = paper_linear();
  const Vec3 start(-20.0, -50.0, 395.0);
  EXPECT_LT((place_at(line, 0.0) - start).norm(), kRounding_mm);
  EXPECT_LT((place_at(line, 6.0) - start - Vec3(40.0, 100.0, 10.0)).norm(), kRounding_mm);
  EXPECT_LT((place_at(line, 3.0) - place_at(line, 9.0)).norm(), kRounding_mm);
  // 108.1665 mm in 6 s
  EXPECT_NEAR((place_at(line, 2.0) - place_at(line, 1.0)).norm(), 18.0278, 1e-4);
}

TEST(TrajectoryTest, PaperCircleIsHalfACircleBulgingToPositiveX) {
  const Trajectory circle = paper_circular();
  const Vec3 first(-68.5, 68.0, 385.0);
  const Vec3 last(-60.5, -93.0, 476.0);
  const Vec3 center = (first + last) / 2.0;
  const double radius_mm = 92.5554;  // half of the chord of 185.1108 mm
  EXPECT_LT((place_at(circle, 0.0) - first).norm(), kRounding_mm);
  EXPECT_LT((place_at(circle, 6.0) - last).norm(), kRounding_mm);
  for (const double t_s : {0.5, 1.7, 3.0, 4.4, 7.7}) {
    EXPECT_NEAR((place_at(circle, t_s) - center).norm(), radius_mm, 1e-4) << t_s;
  }
  const Vec3 top = place_at(circle, 3.0) - center;
  EXPECT_GT(top.x(), 92.0);
  EXPECT_NEAR(top.dot(last - first), 0.0, 1e-6);
}

// Forward kinematics by hand. Start: base 0, upper link along -x, fore link at -270 degrees: (-0.16, 0.21) m.
// End: base 1 m, upper link at -45 degrees, fore link along +x: (1 + 0.16 / sqrt 2 + 0.21, -0.16 / sqrt 2) m.
TEST(TrajectoryTest, ScoutIsATenthOfThePapersManipulator) {
  const Trajectory path = scout();
  ASSERT_EQ(path.period, std::chrono::seconds{6});
  const Vec3 way_mm = place_at(path, 3.0) - place_at(path, 0.0);
  EXPECT_NEAR(way_mm.x(), 100.0 * (1.0 + 0.16 / std::numbers::sqrt2 + 0.21 + 0.16), 1e-6);
  EXPECT_NEAR(way_mm.y(), 100.0 * (0.16 / std::numbers::sqrt2 + 0.21), 1e-6);
  EXPECT_NEAR(way_mm.z(), 0.0, kRounding_mm);
  const Vec3 middle_mm = (place_at(path, 3.0) + place_at(path, 0.0)) / 2.0;
  EXPECT_LT((middle_mm - Vec3(0.0, 0.0, 400.0)).norm(), 0.002);
  // Half way: base 0.5 m, upper link at -112.5 degrees, fore link at -112.5 - 22.5 = -135 degrees.
  const double x_m = 0.5 + 0.16 * std::cos(-1.9634954) + 0.21 * std::cos(-2.3561945);
  EXPECT_NEAR(place_at(path, 1.5).x() - place_at(path, 0.0).x(), 100.0 * (x_m + 0.16), 1e-5);
}

TEST(TrajectoryTest, PhaseIsTheTimeSince1970ModuloThePeriod) {
  const Trajectory line = paper_linear();
  const Duration now = std::chrono::seconds{1'790'000'004} + std::chrono::milliseconds{250};
  ASSERT_EQ(line.period, std::chrono::seconds{12});
  const double phase_s = static_cast<double>(1'790'000'004 % 12) + 0.25;
  EXPECT_LT((target_pose_at(line, now).translation() - place_at(line, phase_s)).norm(), kRounding_mm);
  EXPECT_LT((place_at(line, -1.0) - place_at(line, 11.0)).norm(), kRounding_mm);
}

TEST(TrajectoryTest, VolumeTourStandsStillAtEveryStation) {
  const Trajectory tour = static_volume();
  const std::vector<Vec3> stations = volume_stations();
  ASSERT_EQ(stations.size(), 27U);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double arrival_s = static_cast<double>(i) * (kStationHold_s + kStationMove_s);
    EXPECT_LT((place_at(tour, arrival_s) - stations[i]).norm(), kRounding_mm) << i;
    EXPECT_LT((place_at(tour, arrival_s + kStationHold_s) - stations[i]).norm(), kRounding_mm) << i;
  }
}

TEST(TrajectoryTest, ShiningSideLooksAtTheCameras) {
  for (const Trajectory& trajectory : {paper_linear(), paper_circular(), scout(), static_volume()}) {
    const Isometry3 pose = target_pose_at(trajectory, std::chrono::seconds{5});
    EXPECT_LT((pose.linear() * Vec3::UnitZ() + Vec3::UnitZ()).norm(), kRounding_mm);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, kRounding_mm);
  }
}

TEST(TrajectoryTest, UnknownScenarioIsRefusedWithTheKnownOnes) {
  EXPECT_TRUE(scenario_trajectory("static-volume"));
  const Result<Trajectory> refused = scenario_trajectory("paper-square");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
  EXPECT_NE(refused.error().message.find("paper-linear"), std::string::npos);
}

TEST(TrajectoryTest, FileIsInterpolatedInPlaceAndRotation) {
  // A quarter turn about z while going 10 mm along x: half way is an eighth of a turn.
  const Result<Trajectory> loaded =
      loaded_from("t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n5,0,0,400,1,0,0,0\r\n7,10,0,400,0.70710678,0,0,0.70710678\n");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->period, std::chrono::seconds{2});
  const Isometry3 half = target_pose_at(*loaded, std::chrono::seconds{1});
  EXPECT_LT((half.translation() - Vec3(5.0, 0.0, 400.0)).norm(), kRounding_mm);
  const Vec3 x_axis = half.linear() * Vec3::UnitX();
  EXPECT_NEAR(std::atan2(x_axis.y(), x_axis.x()), std::numbers::pi / 4.0, 1e-8);  // eight digits in the file
}

TEST(TrajectoryTest, MissingFileIsNamed) {
  const Result<Trajectory> loaded = load_trajectory("/nowhere/motion.csv");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::kCannotRead);
  EXPECT_NE(loaded.error().message.find("/nowhere/motion.csv"), std::string::npos);
}

TEST(TrajectoryTest, BadTablesAreRefusedWithTheirLine) {
  const std::string header = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
  const std::string good = "0,0,0,400,1,0,0,0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"t,x,y,z\n" + good, "line 1"},
      {header + good + "1,0,0,400,1,0,0\n", "line 3"},
      {header + good + "1,0,0,400,1,0,0,0,9\n", "line 3"},
      {header + good + "1,0,0,nan,1,0,0,0\n", "line 3"},
      {header + good + "1,0,x,400,1,0,0,0\n", "line 3"},
      {header + good + "1,0,0,400,2,0,0,0\n", "unit quaternion"},
      {header + good, "two samples"},
      {header + good + good, "increase"},
  };
  for (const auto& [text, expected] : cases) {
    const Result<Trajectory> loaded = loaded_from(text);
    ASSERT_FALSE(loaded) << text;
    EXPECT_EQ(loaded.error().code, ErrorCode::kMalformed) << text;
    EXPECT_NE(loaded.error().message.find(expected), std::string::npos) << loaded.error().message;
  }
}

}  // namespace
}  // namespace tripoint
