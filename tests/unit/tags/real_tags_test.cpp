// Pictures of other people: the tags that they list, at the corners that they list.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "capture/image_file.h"
#include "places.h"
#include "tags/tag_detector.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

constexpr double kPixelCentre_px = 0.5;  // the lists have pixel centres at halves

struct ListedTag {
  int id = 0;
  std::array<double, 8> corners{};
};

std::vector<ListedTag> listed_in(const fs::path& file) {
  std::ifstream text(file);
  std::vector<ListedTag> listed;
  for (std::string row; std::getline(text, row);) {
    ListedTag tag;
    auto& c = tag.corners;
    if (std::sscanf(row.c_str(), "%d, (%lf %lf), (%lf %lf), (%lf %lf), (%lf %lf)", &tag.id, &c[0], &c[1], &c[2], &c[3],
                    &c[4], &c[5], &c[6], &c[7]) == 9) {
      listed.push_back(tag);
    }
  }
  return listed;
}

/// The largest distance between corners of the same number.
double apart_px(const ListedTag& listed, const TagOutline& seen) {
  double most_px = 0.0;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    most_px = std::max(most_px, std::hypot(seen.corners_px[k].u_px + kPixelCentre_px - listed.corners[2 * k],
                                           seen.corners_px[k].v_px + kPixelCentre_px - listed.corners[2 * k + 1]));
  }
  return most_px;
}

bool is_measured(const SeenTag& tag) { return tag.outline.cause == TagCause::kKept; }

class RealTagsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(data_)) GTEST_SKIP() << "no such folder: " << data_ << "; set TRIPOINT_SHARED";
  }

  std::vector<SeenTag> seen_in(const fs::path& file) {
    const Result<LoadedImage> image = LoadedImage::load(data_ / file);
    EXPECT_TRUE(image) << image.error().message;
    std::vector<SeenTag> seen;
    if (!image) return seen;
    for (const SeenTag& tag : detector_->detect(image->picture()).tags) {
      if (tag.outline.cause != TagCause::kUnsureBits) seen.push_back(tag);
    }
    return seen;
  }
  std::vector<int> ids_in(const fs::path& file) {
    std::vector<int> ids;
    for (const SeenTag& tag : seen_in(file)) ids.push_back(tag.decoded.id);
    return ids;
  }

  fs::path data_ = test::shared_folder() / "data";
  Result<TagDetector> detector_ = TagDetector::open({});
};

// Their cells are 1.5 to 5.5 px large, in the sun on bent paper: what lies beside the edges and within does not agree
// with the corners to a tenth of a pixel, so that none of them need be measured.
TEST_F(RealTagsTest, OnTheCubesOfSwarmathonEachListedTagIsSeenWithinAPixel) {
  for (const auto& [name, count] : {std::pair{"33369213973_9d9bb4cc96_c", 12}, {"34139872896_defdb2f8d9_c", 10}}) {
    const fs::path picture = fs::path("apriltag_swarmathon") / (std::string(name) + ".jpg");
    const std::vector<ListedTag> listed = listed_in((data_ / picture).replace_extension(".txt"));
    ASSERT_EQ(listed.size(), static_cast<std::size_t>(count));
    const std::vector<SeenTag> found = seen_in(picture);
    EXPECT_EQ(found.size(), listed.size());
    for (const ListedTag& tag : listed) {
      double nearest_px = 1e9;
      for (const SeenTag& seen : found) {
        if (seen.decoded.id == tag.id) nearest_px = std::min(nearest_px, apart_px(tag, seen.outline));
      }
      EXPECT_LE(nearest_px, 1.0) << name << ": tag at " << tag.corners[0] << ", " << tag.corners[1];
    }
  }
}

TEST_F(RealTagsTest, InDuckietownAsManyTagsAsItsListCounts) {
  const std::vector<std::size_t> counts{6, 5, 6, 6, 4, 6, 6, 3, 5, 4};
  const std::vector<int> ids_of_set{22, 24, 58, 85, 144, 198};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string number = (i < 9 ? "0" : "") + std::to_string(i + 1);
    const std::vector<int> ids = ids_in("apriltag_duckietown/test_image_multiple_" + number + ".png");
    EXPECT_EQ(ids.size(), counts[i]) << number;
    for (const int id : ids) EXPECT_TRUE(std::count(ids_of_set.begin(), ids_of_set.end(), id)) << id;
  }
}

TEST_F(RealTagsTest, OnTheFieldOf2024TheTagsOfEachPlace) {
  const std::map<std::string, std::vector<int>> ids{
      {"Amp_42in", {5}},        {"Amp_85in", {5}},        {"BackAmpZone_117in", {2, 3, 4}}, {"Loading_83in", {9, 10}},
      {"Podium_103in", {3, 4}}, {"StageLeft_51in", {15}}, {"StageRight_51in", {12}}};
  for (const auto& [name, expected] : ids) {
    const std::string picture = "apriltag_frc2024/" + name + ".jpg";
    EXPECT_EQ(ids_in(picture), expected) << name;
    for (const SeenTag& tag : seen_in(picture)) {
      // 29 px wide: light of its cells reaches over its border
      const bool small = tag.decoded.id == 2;
      EXPECT_TRUE(small || is_measured(tag)) << name << ": " << tripoint::name(tag.outline.cause);
    }
  }
}

// Their border is two bits wide: that is none of the families, and none of its tags may be made of it.
TEST_F(RealTagsTest, OnABoardOfAnotherKindThereIsNone) {
  for (const char* picture : {"aprilgrid/EuRoC.png", "aprilgrid/iphone.png"}) EXPECT_TRUE(seen_in(picture).empty());
}

TEST_F(RealTagsTest, OnChessboardsThereIsNone) {
  for (const auto& entry : fs::directory_iterator(data_ / "stereo_opencv_chessboard")) {
    if (entry.path().extension() != ".jpg") continue;
    EXPECT_TRUE(seen_in(fs::relative(entry.path(), data_)).empty()) << entry.path();
  }
}

}  // namespace
}  // namespace tripoint
