#include "capture/band_choice.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <utility>
#include <vector>

namespace tripoint {
namespace {

constexpr ImageSize kSize{640, 480};
constexpr TimePoint kForecastAt{Duration{1'000'000'000}};
constexpr Duration kPeriod = std::chrono::milliseconds(33);

/// Places of a target's points in the left picture, one pixel of standard deviation each.
Forecast forecast_at(const std::vector<RawPixel>& places) {
  Forecast forecast;
  forecast.number = 7;
  forecast.at = kForecastAt;
  int id = 1;
  for (const RawPixel& place : places) {
    ForecastPoint point;
    point.id = id++;
    point.at = {place, {0.0, 0.0}};
    point.covariance_px2 = {Matrix2::Identity(), Matrix2::Identity()};
    forecast.points.push_back(point);
  }
  return forecast;
}

Observation seen_at(std::uint32_t frame, Coverage coverage, const std::vector<RawPixel>& places) {
  Observation seen;
  seen.frame = frame;
  seen.coverage = coverage;
  seen.exposed = kForecastAt - kPeriod;
  for (const RawPixel& place : places) {
    ImagePoint point;
    point.at = place;
    point.reach_px = 24;
    seen.points.push_back(point);
  }
  return seen;
}

NextPicture next_picture(std::uint32_t frame) { return {Side::kLeft, frame, kForecastAt, kSize}; }

const std::vector<RawPixel> kOne{{300.0, 200.0}};

/// A whole picture with number 10 that shows what is forecast; the next one has number 11.
class BandChoiceTest : public ::testing::Test {
 protected:
  [[nodiscard]] bool whole() const { return chosen_bands(sightings_, forecast_, next_).empty(); }
  void see(std::uint32_t frame, Coverage coverage, const std::vector<RawPixel>& places) {
    sightings_ = with(sightings_, seen_at(frame, coverage, places), forecast_);
  }

  Forecast forecast_ = forecast_at(kOne);
  Sightings sightings_ = with({}, seen_at(10, Coverage::kWholeFrame, kOne), forecast_);
  NextPicture next_ = next_picture(11);
};

TEST_F(BandChoiceTest, ABandHoldsFourSigmaAndWhatHadASay) {
  const RowBands bands = chosen_bands(sightings_, forecast_, next_);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0], (RowBand{200 - 4 - 4 - 24, 200 + 4 + 4 + 24 + 1}));  // 4 sigma, 4 px in reserve, reach
}

TEST_F(BandChoiceTest, TheForecastIsMovedToTheTimeOfThePicture) {
  forecast_.points[0].velocity_px_per_s.left = {0.0, 300.0};
  see(10, Coverage::kWholeFrame, {{300.0, 200.0 - 9.9}});  // 33 ms before
  next_.exposed = kForecastAt + std::chrono::milliseconds(20);
  const RowBands bands = chosen_bands(sightings_, forecast_, next_);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_NEAR((bands[0].top_px + bands[0].bottom_px - 1) / 2.0, 206.0, 0.51);
  EXPECT_GT(bands[0].bottom_px - bands[0].top_px, 65);  // and is less certain there
}

TEST_F(BandChoiceTest, EachSideHasItsOwnPlace) {
  forecast_.points[0].at.right = {100.0, 90.0};
  EXPECT_EQ(chosen_bands(sightings_, forecast_, next_)[0].top_px, 200 - 32);
  next_.side = Side::kRight;
  EXPECT_EQ(chosen_bands(sightings_, forecast_, next_)[0].top_px, 90 - 32);
}

TEST_F(BandChoiceTest, ABandEndsWithThePicture) {
  for (const auto& [v_px, band] : {std::pair{5.0, RowBand{0, 38}}, std::pair{475.0, RowBand{443, 480}}}) {
    forecast_ = forecast_at({{300.0, v_px}});
    see(10, Coverage::kWholeFrame, {{300.0, v_px}});
    ASSERT_EQ(chosen_bands(sightings_, forecast_, next_).size(), 1U);
    EXPECT_EQ(chosen_bands(sightings_, forecast_, next_)[0], band);
  }
}

TEST_F(BandChoiceTest, TheLargestReachIsForgottenSlowly) {
  Observation big = seen_at(11, Coverage::kWholeFrame, kOne);
  big.points[0].reach_px = 40;
  sightings_ = with(sightings_, big, forecast_);
  EXPECT_EQ(sightings_.reach_px, 40);
  see(12, Coverage::kRegions, kOne);
  EXPECT_EQ(sightings_.reach_px, 39);
  for (std::uint32_t frame = 13; frame < 60; ++frame) see(frame, Coverage::kWholeFrame, kOne);
  EXPECT_EQ(sightings_.reach_px, 24);
}

TEST_F(BandChoiceTest, WholeBeforeAnythingWasSeen) {
  sightings_ = {};
  EXPECT_TRUE(whole());
  see(10, Coverage::kRegions, kOne);  // and regions do not stand in for it
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeAtEveryFifthFrameHoweverManyWereDropped) {
  for (std::uint32_t frame = 11; frame < 15; ++frame) {
    next_ = next_picture(frame);
    EXPECT_FALSE(whole()) << frame;
    see(frame, Coverage::kRegions, kOne);
  }
  next_ = next_picture(15);
  EXPECT_TRUE(whole());
  see(15, Coverage::kWholeFrame, kOne);
  next_ = next_picture(20);  // 16 to 19 never came
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhenTheDriverCountsAnew) {
  next_ = next_picture(0);
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhileTheLastWholePictureShowedMoreOrFewerSpots) {
  see(11, Coverage::kWholeFrame, {kOne[0], {20.0, 30.0}});
  see(12, Coverage::kRegions, kOne);
  next_ = next_picture(13);
  EXPECT_TRUE(whole());
  see(13, Coverage::kWholeFrame, {});
  see(14, Coverage::kRegions, kOne);
  next_ = next_picture(15);
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhenTheLastPictureWasNotLookedAtToTheEnd) {
  for (const Coverage coverage : {Coverage::kWholeFrame, Coverage::kRegions}) {
    see(10, Coverage::kWholeFrame, kOne);
    Observation cut = seen_at(11, coverage, kOne);
    cut.health.candidates_cut = true;
    sightings_ = with(sightings_, cut, forecast_);
    next_ = next_picture(12);
    EXPECT_TRUE(whole());
  }
}

TEST_F(BandChoiceTest, WholeAfterAMissedSpotAndAfterOneMore) {
  see(11, Coverage::kRegions, {});
  next_ = next_picture(12);
  EXPECT_TRUE(whole());
  see(11, Coverage::kRegions, {kOne[0], {310.0, 201.0}});
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhenTheLastSpotsWereNotForeseen) {
  // Margin 4 px and 4 sigma; sigma 1 px and 33 ms of 60 px/s: 2.2 px, in all 12.9 px.
  see(10, Coverage::kWholeFrame, {{300.0, 212.0}});
  EXPECT_FALSE(whole());
  see(10, Coverage::kWholeFrame, {{300.0, 213.5}});
  EXPECT_TRUE(whole());
  see(10, Coverage::kWholeFrame, {{313.5, 200.0}});
  EXPECT_TRUE(whole());
  sightings_ = with({}, seen_at(10, Coverage::kWholeFrame, kOne), Forecast{});
  EXPECT_TRUE(whole());
  Forecast other_time = forecast_;
  other_time.at = kForecastAt - std::chrono::seconds(1);
  sightings_ = with({}, seen_at(10, Coverage::kWholeFrame, kOne), other_time);
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWithoutAForecast) {
  forecast_ = {};
  EXPECT_TRUE(whole());
  see(10, Coverage::kWholeFrame, {});  // nothing forecast, nothing seen: they agree, and mean nothing
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhenTheForecastIsMeantForAnotherTime) {
  for (const int apart_ms : {-71, 71}) {
    next_.exposed = kForecastAt + std::chrono::milliseconds(apart_ms);
    EXPECT_TRUE(whole()) << apart_ms;
  }
  for (const int apart_ms : {-69, 69}) {
    next_.exposed = kForecastAt + std::chrono::milliseconds(apart_ms);
    EXPECT_FALSE(whole()) << apart_ms;
  }
}

TEST_F(BandChoiceTest, WholeWhenAPlaceIsTooUncertainOrNoNumber) {
  forecast_.points[0].covariance_px2.left = 19.0 * 19.0 * Matrix2::Identity();
  EXPECT_FALSE(whole());
  forecast_.points[0].covariance_px2.left = 21.0 * 21.0 * Matrix2::Identity();
  EXPECT_TRUE(whole());
  forecast_.points[0].covariance_px2.left *= std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(whole());
}

TEST_F(BandChoiceTest, WholeWhenAPointMayLieOutsideThePicture) {
  for (const RawPixel outside : {RawPixel{300.0, -1.0}, RawPixel{300.0, 480.0}, RawPixel{-1.0, 200.0},
                                 RawPixel{640.0, 200.0}, RawPixel{300.0, std::numeric_limits<double>::quiet_NaN()}}) {
    forecast_ = forecast_at({outside});
    EXPECT_TRUE(whole()) << outside.u_px << "," << outside.v_px;
  }
}

TEST_F(BandChoiceTest, WholeWhenTheBandsCoverMoreThanHalf) {
  const auto three = [&](double apart_px) {
    const std::vector<RawPixel> places{{100.0, 200.0}, {300.0, 200.0 + apart_px}, {500.0, 200.0 + 2.0 * apart_px}};
    forecast_ = forecast_at(places);
    see(10, Coverage::kWholeFrame, places);
  };
  three(87.0);  // 2 x 87 + 65 rows of 480
  EXPECT_FALSE(whole());
  EXPECT_EQ(chosen_bands(sightings_, forecast_, next_).size(), 3U);
  three(64.0);  // they touch: rows are counted once
  EXPECT_FALSE(whole());
  forecast_.points[0].at.left.v_px = 50.0;
  EXPECT_FALSE(whole());  // 65 + 129
  const std::vector<RawPixel> four{{100.0, 50.0}, {200.0, 150.0}, {300.0, 250.0}, {400.0, 350.0}};
  forecast_ = forecast_at(four);
  see(10, Coverage::kWholeFrame, four);
  EXPECT_TRUE(whole());  // 260
}

}  // namespace
}  // namespace tripoint
