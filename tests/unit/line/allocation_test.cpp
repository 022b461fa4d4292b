// The line does not allocate once it runs.
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "blinking_observations.h"
#include "counted_allocations.h"
#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::allocations_in;
using testing::at_rest;

LineModel heavy_model() {
  LineModel model = testing::webcam_model();
  model.covariance.diagonal().setConstant(1e-4);
  return model;
}

long allocations_of_a_run(
    const LineModel& model, std::vector<Event> events, void (*on_verdict)() = [] {}) {
  events.push_back(CameraLost{Side::kLeft, TimePoint{duration_from_seconds(3.5)}});
  events.push_back(CameraBack{Side::kLeft, TimePoint{duration_from_seconds(3.6)}});
  events.push_back(Tick{TimePoint{duration_from_seconds(5.0)}});
  Line line(testing::shared_model(model));
  std::size_t found = 0;
  const long count = allocations_in([&] {
    for (const Event& event : events) {
      if (line.step(event)) {
        ++found;
        on_verdict();
      }
      if (line.forecast().number > 1'000'000) std::abort();
    }
  });
  EXPECT_GT(found, 50U);
  return count;
}

testing::Shooting two_seconds() {
  testing::Shooting shooting = testing::free_running();
  shooting.duration_s = 2.0;
  return shooting;
}

class AllocationTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::allocations_are_counted()) GTEST_SKIP() << "a sanitizer stands in for malloc: nothing can be counted";
  }
};

TEST_F(AllocationTest, TheCounterSeesPlantedAllocations) {
  volatile Eigen::Index size = 5;
  EXPECT_GE(allocations_in([&] { const std::vector<double> planted(static_cast<std::size_t>(size), 1.0); }), 1);
  EXPECT_GE(allocations_in([&] { const Eigen::VectorXd planted = Eigen::VectorXd::Ones(size); }), 1);
}

TEST_F(AllocationTest, ARunSeesAnAllocationPlantedInEachVerdict) {
  const LineModel model = heavy_model();
  static volatile std::size_t size = 5;
  const auto plant = [] { const std::vector<double> planted(size, 1.0); };
  EXPECT_GT(allocations_of_a_run(model, testing::shot(model, {testing::circle(100.0)}, two_seconds()), plant), 50);
}

TEST_F(AllocationTest, OnePointAllocatesNothing) {
  const LineModel model = heavy_model();
  EXPECT_EQ(allocations_of_a_run(model, testing::shot(model, {testing::circle(100.0)}, two_seconds())), 0);
}

TEST_F(AllocationTest, ThePapersMethodAllocatesNothing) {
  LineModel model = heavy_model();
  model.method = Method::kPaper;
  EXPECT_EQ(allocations_of_a_run(model, testing::shot(model, {testing::circle(100.0)}, two_seconds())), 0);
}

TEST_F(AllocationTest, SwitchedLedsAllocateNothing) {
  LineModel model = testing::model_of(2);
  model.covariance.diagonal().setConstant(1e-4);
  const std::vector<testing::Path> leds{testing::circle(100.0), at_rest({40.0, -60.0, 400.0})};
  EXPECT_EQ(allocations_of_a_run(model, testing::blinking(leds, two_seconds())), 0);
}

/// A triangle that keeps its shape.
std::vector<testing::Path> moving_triangle() {
  std::vector<testing::Path> paths;
  for (const Vec3& led : {Vec3(80.0, 0.0, 0.0), Vec3(20.0, -50.0, 0.0), Vec3(0.0, 0.0, 0.0)}) {
    paths.push_back([led, path = testing::circle(100.0)](double time_s) -> Vec3 { return path(time_s) + led; });
  }
  return paths;
}

TEST_F(AllocationTest, AFullPoseAllocatesNothing) {
  LineModel model = heavy_model();
  model.covariance *= 1e-4;
  model.target.points.push_back({2, {80.0, 0.0, 0.0}, 0.05});
  model.target.points.push_back({3, {20.0, 50.0, 0.0}, 0.05});
  EXPECT_EQ(allocations_of_a_run(model, testing::shot(model, moving_triangle(), two_seconds())), 0);
}

TEST_F(AllocationTest, TwelvePointsAndErrorsAllocateNothing) {
  const LineModel model = heavy_model();
  std::vector<testing::Path> paths;
  for (int i = 0; i < 12; ++i) paths.push_back(at_rest({-80.0 + 14.0 * i, -70.0 + 12.0 * i, 400.0}));
  EXPECT_EQ(allocations_of_a_run(model, testing::shot(model, paths, two_seconds())), 0);
}

}  // namespace
}  // namespace tripoint
