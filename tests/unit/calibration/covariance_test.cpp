#include "calibration/covariance.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using ::testing::HasSubstr;

/// Very different units on the diagonal, as in a real calibration, and a correlation between the first two.
RigCovariance covariance_with(double correlation) {
  RigCovariance covariance = RigCovariance::Identity();
  covariance(0, 0) = 1e4;
  covariance(1, 1) = 1e-8;
  covariance(0, 1) = covariance(1, 0) = correlation * std::sqrt(1e4 * 1e-8);
  return covariance;
}

TEST(CovarianceTest, ACovarianceIsAccepted) { EXPECT_EQ(fault_of_covariance(covariance_with(0.9)), ""); }

TEST(CovarianceTest, ParametersThatWereHeldHaveNoVariance) {
  EXPECT_EQ(fault_of_covariance(RigCovariance::Zero()), "");
}

TEST(CovarianceTest, FullCorrelationIsTheBorder) {
  EXPECT_EQ(fault_of_covariance(covariance_with(1.0)), "");
  EXPECT_THAT(fault_of_covariance(covariance_with(1.0001)), HasSubstr("positive semidefinite"));
}

TEST(CovarianceTest, ANegativeVarianceIsNamed) {
  RigCovariance covariance = RigCovariance::Identity();
  covariance(4, 4) = -1e-12;
  EXPECT_THAT(fault_of_covariance(covariance), HasSubstr("row 5"));
}

TEST(CovarianceTest, AnAsymmetryIsNamedWithItsPlace) {
  RigCovariance covariance = covariance_with(0.5);
  covariance(0, 1) *= 1.001;
  EXPECT_THAT(fault_of_covariance(covariance), HasSubstr("row 1, column 2"));
}

TEST(CovarianceTest, RoundingToSevenDigitsIsNoAsymmetry) {
  RigCovariance covariance = covariance_with(0.5);
  covariance(0, 1) *= 1.0 + 1e-7;
  EXPECT_EQ(fault_of_covariance(covariance), "");
}

TEST(CovarianceTest, ACorrelationWithAHeldParameterIsRefused) {
  RigCovariance covariance = RigCovariance::Identity();
  covariance(3, 3) = 0.0;
  covariance(3, 5) = covariance(5, 3) = 0.1;
  EXPECT_THAT(fault_of_covariance(covariance), HasSubstr("positive semidefinite"));
}

TEST(CovarianceTest, WhatIsNoNumberIsRefused) {
  RigCovariance covariance = RigCovariance::Identity();
  covariance(2, 2) = std::nan("");
  EXPECT_NE(fault_of_covariance(covariance), "");
}

}  // namespace
}  // namespace tripoint
