#include "explain/finding.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tripoint {
namespace {

Candidate candidate_of(DropCause cause, float contrast = 0.0F, float peak = 0.0F) {
  Candidate candidate;
  candidate.cause = cause;
  candidate.contrast = contrast;
  candidate.peak = peak;
  return candidate;
}

ImagePoint point_with(double variance_px2) {
  ImagePoint point;
  point.covariance_px2 = variance_px2 * Matrix2::Identity();
  return point;
}

std::vector<int> numbers(const std::vector<Finding>& findings) {
  std::vector<int> list(findings.size());
  std::transform(findings.begin(), findings.end(), list.begin(), [](const Finding& finding) { return finding.number; });
  return list;
}

TEST(FindingTest, KeptOnesComeFirstWithTheirOwnUncertainty) {
  CandidateLog log;
  log.push_back(candidate_of(DropCause::kDim));
  log.push_back(candidate_of(DropCause::kKept));
  log.push_back(candidate_of(DropCause::kKept));
  Detection detection;
  detection.points.push_back(point_with(0.01));
  detection.points.push_back(point_with(0.04));
  const auto findings = findings_of(log, detection);
  EXPECT_EQ(numbers(findings), (std::vector{2, 3, 1}));
  EXPECT_DOUBLE_EQ((*findings[0].covariance_px2)(0, 0), 0.01);
  EXPECT_DOUBLE_EQ((*findings[1].covariance_px2)(0, 0), 0.04);
  EXPECT_FALSE(findings[2].covariance_px2);
}

TEST(FindingTest, OfEachCauseTheStrongestThenOfEachTheNext) {
  CandidateLog log;
  log.push_back(candidate_of(DropCause::kDim, 0.0F, 700.0F));
  log.push_back(candidate_of(DropCause::kDim, 0.0F, 800.0F));
  log.push_back(candidate_of(DropCause::kNotRed, 100.0F));
  log.push_back(candidate_of(DropCause::kNotRed, 300.0F));
  log.push_back(candidate_of(DropCause::kSeenBefore, 900.0F));
  EXPECT_EQ(numbers(findings_of(log, {})), (std::vector{4, 2, 5, 3, 1}));
}

TEST(FindingTest, NothingLookedAtIsNothingFound) { EXPECT_TRUE(findings_of({}, {}).empty()); }

}  // namespace
}  // namespace tripoint
