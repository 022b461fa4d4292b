#include "app/verdict_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tripoint {
namespace {

using nlohmann::json;

TEST(VerdictJsonTest, WithoutAPoseEverythingUnknownIsNull) {
  Measurement measurement;
  measurement.sequence = 7;
  measurement.exposed = time_from_ns(123);
  measurement.faults = {Fault::kNotSeenLeft, Fault::kAmbiguous};
  const json line = json::parse(verdict_json(measurement, OutputFrame::kReference));
  EXPECT_EQ(line["t_ns"], 123);
  EXPECT_EQ(line["sequence"], 7);
  EXPECT_EQ(line["valid"], false);
  EXPECT_EQ(line["mount_watched"], false);
  EXPECT_EQ(line["faults"], (json{"not_seen_left", "ambiguous"}));
  EXPECT_TRUE(line["position_mm"].is_null());
  EXPECT_TRUE(line["covariance"].is_null());
  EXPECT_TRUE(line["side_length_error_mm"].is_null());
  EXPECT_TRUE(line["decalibration_mm"].is_null());
  EXPECT_EQ(line["frame"], "reference");
}

TEST(VerdictJsonTest, APositionHasThreeByThreeCovariancesSummed) {
  Measurement measurement;
  TargetPose pose;
  pose.position_in_output_mm = Vec3(1.0, 2.0, 3.0);
  pose.noise(0, 0) = 0.25;
  pose.shared(0, 0) = 0.5;
  measurement.pose = pose;
  const json line = json::parse(verdict_json(measurement, OutputFrame::kLeftCamera));
  EXPECT_EQ(line["position_mm"], (json{1.0, 2.0, 3.0}));
  ASSERT_EQ(line["covariance"].size(), 3U);
  EXPECT_EQ(line["covariance"][0][0], 0.75);
  EXPECT_EQ(line["covariance_shared"][0][0], 0.5);
  EXPECT_TRUE(line["quaternion_wxyz"].is_null());
  EXPECT_EQ(line["frame"], "left_camera");
}

TEST(VerdictJsonTest, WhatTheMountShowsIsToldBesideAFaultToo) {
  Measurement measurement;
  measurement.faults = {Fault::kDecalibration};
  measurement.side_length_error_mm = -0.25;
  measurement.decalibration_mm = 2.5;
  const json line = json::parse(verdict_json(measurement, OutputFrame::kReference));
  EXPECT_EQ(line["side_length_error_mm"], -0.25);
  EXPECT_EQ(line["decalibration_mm"], 2.5);
}

TEST(VerdictJsonTest, AnOrientationHasAPositiveScalarPart) {
  Measurement measurement;
  TargetPose pose;
  pose.output_from_target = Eigen::AngleAxisd(3.5, Vec3::UnitZ()).toRotationMatrix();  // w = cos(1.75) < 0
  measurement.pose = pose;
  const json line = json::parse(verdict_json(measurement, OutputFrame::kReference));
  EXPECT_EQ(line["orientation_valid"], true);
  EXPECT_EQ(line["covariance"].size(), 6U);
  EXPECT_NEAR(line["quaternion_wxyz"][0].get<double>(), -std::cos(1.75), 1e-12);
}

}  // namespace
}  // namespace tripoint
