// Pictures of other people, the way `tripointd detect` reads them: tags and boards show no red LED. What is kept in the
// others was looked at with `--explain`, and is listed here for what it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/detector_settings.h"
#include "capture/image_file.h"
#include "config/config.h"
#include "line/detect/led_detector.h"
#include "line/detect/sphere_detector.h"
#include "places.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

struct KnownSpot {
  std::string_view picture;
  RawPixel at;
  std::string_view what;
};

constexpr double kSamePlace_px = 1.0;

/// Red lights, of machines and of a hand-held laser.
const std::vector<KnownSpot> kRedLights{
    {"CargoSideStraightDark72in.jpg", {302.7, 121.5}, "status light, upper of two"},
    {"BlueGoal-180in-Center.jpg", {528.7, 453.5}, "row of LEDs, lower of two"},
    {"BlueGoal-180in-Center.jpg", {59.2, 474.1}, "row of LEDs"},
    {"BlueGoal-224in-Left.jpg", {372.8, 425.4}, "row of LEDs, lower of two"},
    {"BlueGoal-224in-Left.jpg", {372.3, 420.0}, "row of LEDs, upper of two"},
    {"Amp_85in.jpg", {978.8, 382.1}, "beacon of the field"},
    {"4.jpg", {1435.5, 1146.8}, "dot of a laser"},
};

/// No spheres, and kept by the settings for passive spheres.
const std::vector<KnownSpot> kMistakenForSpheres{
    {"test_image_multiple_07.png", {299.1, 141.3}, "stop sign: flat, and an octagon of 21 px is a circle"},
};

bool is_picture(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".jpg" || ending == ".png";
}

bool is_near(const std::vector<RawPixel>& places, const RawPixel& at, double within_px) {
  return std::any_of(places.begin(), places.end(), [&](const RawPixel& place) {
    return std::hypot(place.u_px - at.u_px, place.v_px - at.v_px) < within_px;
  });
}

bool is_listed(const std::vector<KnownSpot>& list, const std::string& picture, const RawPixel& at) {
  return std::any_of(list.begin(), list.end(), [&](const KnownSpot& known) {
    return known.picture == picture && std::hypot(known.at.u_px - at.u_px, known.at.v_px - at.v_px) < kSamePlace_px;
  });
}

Detection seen_in(const Picture& picture, LedDetector& detector) { return detector.detect(picture, {}); }
Detection seen_in(const Picture& picture, SphereDetector& detector) { return detector.detect(picture); }

bool is_grey(const Picture& picture) { return picture.v.data == nullptr; }

/// A grey picture as one whose colour is neutral everywhere, so that the detector can look at it.
class Neutral {
 public:
  explicit Neutral(const Picture& grey) : picture_(grey) {
    const auto width_px = static_cast<std::size_t>((grey.size.width_px + 1) / 2);
    chroma_.assign(width_px * static_cast<std::size_t>(grey.size.height_px), kNeutral);
    picture_.u = picture_.v = Plane{.data = chroma_.data(), .stride_bytes = width_px, .step_bytes = 1};
  }
  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  static constexpr std::uint8_t kNeutral = 128;  // BT.601
  std::vector<std::uint8_t> chroma_;
  Picture picture_;
};

template <typename Detector>
std::vector<RawPixel> kept_in(const Picture& picture, Detector& detector) {
  std::vector<RawPixel> places;
  for (const ImagePoint& point : seen_in(picture, detector).points) places.push_back(point.at);
  return places;
}

template <typename Detector>
std::vector<RawPixel> kept_in(const fs::path& file, Detector& detector) {
  const Result<LoadedImage> image = LoadedImage::load(file);
  EXPECT_TRUE(image) << image.error().message;
  if (!image) return {};
  EXPECT_FALSE(is_grey(image->picture())) << file;
  return is_grey(image->picture()) ? std::vector<RawPixel>{} : kept_in(image->picture(), detector);
}

struct Counts {
  int in_color = 0;
  int grey = 0;
};

/// In all pictures of a folder, which are so many, nothing is kept but what is listed; in grey ones nothing at all.
void expect_only_listed_in(const std::string& folder, const Counts& pictures_of_set) {
  const fs::path path = test::shared_folder() / "data" / folder;
  if (!fs::is_directory(path)) GTEST_SKIP() << "no such folder: " << path << "; set TRIPOINT_SHARED";
  Counts pictures;
  LedDetector detector{LedDetectorSettings{}};
  for (const auto& entry : fs::directory_iterator(path)) {
    if (!is_picture(entry.path())) continue;
    const std::string name = entry.path().filename().string();
    const Result<LoadedImage> image = LoadedImage::load(entry.path());
    ASSERT_TRUE(image) << image.error().message;
    const Picture& picture = image->picture();
    if (is_grey(picture)) {
      ++pictures.grey;
      EXPECT_TRUE(kept_in(Neutral(picture).picture(), detector).empty()) << name;
      continue;
    }
    ++pictures.in_color;
    for (const RawPixel& at : kept_in(picture, detector)) {
      EXPECT_TRUE(is_listed(kRedLights, name, at)) << name << ": a point at " << at.u_px << ", " << at.v_px;
    }
  }
  EXPECT_EQ(pictures.in_color, pictures_of_set.in_color) << path;
  EXPECT_EQ(pictures.grey, pictures_of_set.grey) << path;
}

fs::path red_spot_scene(const std::string& name) { return test::shared_folder() / "data/red_spot_scenes" / name; }

LedDetectorSettings passive_spot_settings() {
  const Result<Config> config = load_config(test::top_folder() / "deploy/settings/passive_spot.toml", {});
  EXPECT_TRUE(config) << config.error().message;
  return config ? led_detector_settings(config->detector) : LedDetectorSettings{};
}

// No picture of these five is listed. A grey one has no colour to look at: it shows that brightness alone is no spot.
TEST(RealPicturesTest, NothingInSwarmathonTags) { expect_only_listed_in("apriltag_swarmathon", {.in_color = 2}); }
TEST(RealPicturesTest, NothingInDuckietownTags) { expect_only_listed_in("apriltag_duckietown", {.in_color = 10}); }
TEST(RealPicturesTest, NothingInAprilGrids) { expect_only_listed_in("aprilgrid", {.in_color = 1, .grey = 1}); }
TEST(RealPicturesTest, NothingInChessboards) { expect_only_listed_in("stereo_opencv_chessboard", {.grey = 26}); }
TEST(RealPicturesTest, NothingInCharucoBoards) { expect_only_listed_in("charuco_mono_lifecam1280", {.in_color = 16}); }

TEST(RealPicturesTest, OnlyWhatIsListedInFieldTags) { expect_only_listed_in("apriltag_frc2024", {.in_color = 7}); }
TEST(RealPicturesTest, OnlyWhatIsListedInRetroReflectiveTargetsOf2019) {
  expect_only_listed_in("retroreflective_frc/2019", {.in_color = 44});
}
TEST(RealPicturesTest, OnlyWhatIsListedInRetroReflectiveTargetsOf2020) {
  expect_only_listed_in("retroreflective_frc/2020", {.in_color = 19});
}
TEST(RealPicturesTest, OnlyTheLaserInScenesWithRedThings) { expect_only_listed_in("red_spot_scenes", {.in_color = 2}); }

TEST(RealPicturesTest, TheSettingsForPassiveSpotsFindTheRedDiscAndTheLaserAndNothingElse) {
  if (!fs::exists(red_spot_scene("4.jpg"))) GTEST_SKIP() << "no " << red_spot_scene("4.jpg") << "; set TRIPOINT_SHARED";
  LedDetector detector{passive_spot_settings()};
  const std::vector<RawPixel> places = kept_in(red_spot_scene("4.jpg"), detector);
  EXPECT_EQ(places.size(), 2U);
  EXPECT_TRUE(is_near(places, {1611.3, 1153.2}, kSamePlace_px)) << "the disc: where it was seen by eye";
  EXPECT_TRUE(is_near(places, kRedLights.back().at, kSamePlace_px)) << "the laser";
}

SphereSettings passive_sphere_settings() {
  const Result<Config> config = load_config(test::top_folder() / "deploy/settings/passive_spheres.toml", {});
  EXPECT_TRUE(config) << config.error().message;
  EXPECT_TRUE(config && config->detector.kind == ConfiguredDetector::kSphere);
  return config ? sphere_settings(config->detector) : SphereSettings{};
}

/// Where the red of the two balls has its middle: of the two areas with a hue within 16 degrees of red, a saturation
/// over 0.55 and more than 300 px, as OpenCV's HSV gives them. What holds the balls hides a part of them, so that the
/// middles of the balls lie up to 18 px beside; the smaller ball's radius is more than 30 px.
struct Balls {
  std::string_view picture;
  RawPixel upper;
  RawPixel lower;
};
const std::vector<Balls> kBalls{
    {"frame0.jpg", {286.0, 373.0}, {366.0, 483.0}},  {"frame4.jpg", {250.0, 285.0}, {338.0, 407.0}},
    {"frame7.jpg", {228.0, 396.0}, {306.0, 531.0}},  {"frame8.jpg", {303.0, 321.0}, {398.0, 438.0}},
    {"frame11.jpg", {216.0, 298.0}, {307.0, 443.0}}, {"frame16.jpg", {280.0, 310.0}, {375.0, 434.0}},
    {"frame18.jpg", {185.0, 240.0}, {281.0, 388.0}}, {"frame19.jpg", {276.0, 230.0}, {386.0, 353.0}},
};
constexpr double kOnTheBall_px = 20.0;

// Two red balls on an instrument, partly behind it: what holds them hides a quarter of the outline.
void expect_both_balls(const SphereSettings& settings) {
  const fs::path folder = test::shared_folder() / "data/red_balls_davinci/RGB";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no such folder: " << folder << "; set TRIPOINT_SHARED";
  SphereDetector detector{settings};
  int pictures = 0;
  int with_both = 0;
  std::size_t pictures_with_places = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!is_picture(entry.path())) continue;
    ++pictures;
    const std::vector<RawPixel> places = kept_in(entry.path(), detector);
    with_both += places.size() == 2 ? 1 : 0;
    for (const Balls& balls : kBalls) {
      if (entry.path().filename() != balls.picture) continue;
      ++pictures_with_places;
      EXPECT_TRUE(is_near(places, balls.upper, kOnTheBall_px)) << balls.picture;
      EXPECT_TRUE(is_near(places, balls.lower, kOnTheBall_px)) << balls.picture;
    }
  }
  EXPECT_EQ(pictures, 25);
  EXPECT_EQ(pictures_with_places, kBalls.size());
  EXPECT_GE(with_both, 24);
}

TEST(RealPicturesTest, TheSettingsForPassiveSpheresFindBothBalls) { expect_both_balls(passive_sphere_settings()); }
TEST(RealPicturesTest, TheDefaultsForSpheresFindBothBalls) { expect_both_balls({}); }

TEST(RealPicturesTest, TheSettingsForPassiveSpheresFindOnlyWhatIsListedWhereThereIsNoBall) {
  SphereDetector detector{passive_sphere_settings()};
  for (const char* set : {"red_spot_scenes", "apriltag_frc2024", "apriltag_duckietown", "charuco_mono_lifecam1280"}) {
    const fs::path folder = test::shared_folder() / "data" / set;
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no such folder: " << folder << "; set TRIPOINT_SHARED";
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!is_picture(entry.path())) continue;
      const std::string name = entry.path().filename().string();
      for (const RawPixel& at : kept_in(entry.path(), detector)) {
        EXPECT_TRUE(is_listed(kMistakenForSpheres, name, at)) << name << ": " << at.u_px << ", " << at.v_px;
      }
    }
  }
}

}  // namespace
}  // namespace tripoint
