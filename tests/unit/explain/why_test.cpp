#include "explain/why.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

Candidate with(DropCause cause, float Candidate::*measured, float value) {
  Candidate candidate;
  candidate.cause = cause;
  candidate.*measured = value;
  return candidate;
}

std::string why_of(const Candidate& candidate) { return why(candidate, LedDetectorSettings{}, 640); }

TEST(WhyTest, EveryCauseHasWordsAndAReason) {
  for (std::size_t i = 0; i < kDropCauseNames.size(); ++i) {
    const auto cause = static_cast<DropCause>(i);
    EXPECT_FALSE(cause_in_words(cause).empty());
    EXPECT_FALSE(why_of(with(cause, &Candidate::peak, 0.0F)).empty()) << name(cause);
  }
}

TEST(WhyTest, ACauseIsWrittenAsPeopleWriteIt) { EXPECT_EQ(cause_in_words(DropCause::kNotRed), "not red"); }

TEST(WhyTest, AMeasuredValueStandsAgainstItsLimit) {
  EXPECT_EQ(why_of(with(DropCause::kNotRed, &Candidate::redness, 0.31F)), "redness 0.31 < 0.70");
  EXPECT_EQ(why_of(with(DropCause::kElongated, &Candidate::aspect, 3.0F)), "aspect 3.00 > 1.90");
}

TEST(WhyTest, PeakStandsAgainstWhatTheChromaLeavesOfIt) {
  Candidate candidate = with(DropCause::kDim, &Candidate::peak, 612.0F);
  candidate.needed_peak = 679.0F;
  EXPECT_EQ(why_of(candidate), "peak 612 < 679");
}

TEST(WhyTest, ContrastStandsAgainstWhatTheNoiseDemanded) {
  Candidate candidate = with(DropCause::kNoContrast, &Candidate::contrast, 144.0F);
  candidate.needed_contrast = 160.0F;
  EXPECT_EQ(why_of(candidate), "contrast 144 < 160");
}

TEST(WhyTest, TheLimitIsThatOfTheSettings) {
  LedDetectorSettings settings;
  settings.min_emission = -0.1;
  EXPECT_EQ(why(with(DropCause::kTwoLights, &Candidate::parting_px, 2.25F), settings, 640), "parting px 2.2 > 1.0");
  EXPECT_EQ(why(with(DropCause::kNotEmitting, &Candidate::emission, -0.25F), settings, 640), "emission -0.25 < -0.10");
}

TEST(WhyTest, AValueBesideItsLimitDoesNotReadAsTheLimit) {
  EXPECT_EQ(why_of(with(DropCause::kNotRed, &Candidate::redness, 0.6982F)), "redness 0.698 < 0.70");
}

TEST(WhyTest, NothingIsWrittenAsLessThanZero) {
  EXPECT_EQ(why_of(with(DropCause::kNotRed, &Candidate::redness, -0.001F)), "redness 0.00 < 0.70");
  EXPECT_EQ(why_of(with(DropCause::kNotRed, &Candidate::redness, -0.01F)), "redness -0.01 < 0.70");
}

TEST(WhyTest, TheLimitOfARedSurfaceIsThatOfThePicture) {
  Candidate candidate = with(DropCause::kRedSurface, &Candidate::peak, 900.0F);
  candidate.red_surface = 1000.0F;
  EXPECT_EQ(why_of(candidate), "peak 900 < 1045");
}

TEST(WhyTest, TheSizeHasTwoLimits) {
  LedDetectorSettings settings;
  settings.min_sigma_px = 0.5;
  settings.max_sigma_px = 4.0;
  settings.max_sigma_of_width = 0.016;
  const auto of_sigma = [&](float sigma_px) {
    return why(with(DropCause::kWrongSize, &Candidate::sigma_px, sigma_px), settings, 640);
  };
  EXPECT_EQ(of_sigma(0.4F), "sigma 0.40 < 0.50");
  EXPECT_EQ(of_sigma(12.0F), "sigma 12.00 > 10.24");
}

TEST(WhyTest, OfASphereTheValueStandsAgainstItsOwnLimits) {
  SphereSettings settings;
  settings.min_radius_px = 20.0;
  settings.max_radius_px = 70.0;
  const auto of = [&](DropCause cause, float Candidate::*measured, float value) {
    return why(with(cause, measured, value), settings, 640);
  };
  EXPECT_EQ(of(DropCause::kOtherRadius, &Candidate::radius_px, 12.0F), "radius 12.0 < 20.0");
  EXPECT_EQ(of(DropCause::kOtherRadius, &Candidate::radius_px, 80.0F), "radius 80.0 > 70.0");
  EXPECT_EQ(of(DropCause::kHiddenOutline, &Candidate::outline, 0.41F), "outline 0.41 < 0.50");
  EXPECT_EQ(of(DropCause::kNotFilled, &Candidate::fill, 0.31F), "fill 0.31 < 0.50");
  EXPECT_EQ(of(DropCause::kSprawling, &Candidate::spill, 0.25F), "beyond 0.25 > 0.10");
}

TEST(WhyTest, OfASphereEveryCauseHasAReason) {
  for (const DropCause cause :
       {DropCause::kKept, DropCause::kFitFailed, DropCause::kCutByBorder, DropCause::kNoRoom, DropCause::kOtherRadius,
        DropCause::kHiddenOutline, DropCause::kNotFilled, DropCause::kSprawling}) {
    EXPECT_FALSE(why(with(cause, &Candidate::fill, 0.0F), SphereSettings{}, 640).empty()) << name(cause);
  }
}

TEST(WhyTest, AKeptOneTellsWhatWasMeasured) {
  Candidate kept;
  kept.redness = 1.7F;
  kept.sigma_px = 1.25F;
  EXPECT_EQ(why_of(kept), "redness 1.70  sigma 1.25 px");
}

}  // namespace
}  // namespace tripoint
