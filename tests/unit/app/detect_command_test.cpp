// `tripointd detect` on real and broken JPEGs made by others: each file is answered, whatever it holds.
#include "app/detect_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "places.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kWell = 0;
constexpr int kUnreadable = 2;  // docs/reference/tripointd.md

struct Answered {
  int code = -1;
  std::vector<json> lines;
};

Answered answer_for(const DetectOptions& options) {
  testing::internal::CaptureStdout();
  Answered answered;
  answered.code = detect_command(options);
  std::istringstream output(testing::internal::GetCapturedStdout());
  for (std::string line; std::getline(output, line);) answered.lines.push_back(json::parse(line));
  return answered;
}

/// With each detector, and with explanations where there are any.
class DetectCommandTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const fs::path folder = test::shared_folder() / "data/jpeg_stress";
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no such folder: " << folder << "; set TRIPOINT_SHARED";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".jpg") pictures_.push_back(entry.path());
    }
    std::sort(pictures_.begin(), pictures_.end());
  }

  [[nodiscard]] static bool explained() { return GetParam() != "apriltag"; }
  [[nodiscard]] DetectOptions options_for(std::vector<fs::path> pictures) const {
    return {.images = std::move(pictures),
            .config = {},
            .detector = GetParam(),
            .explain = explained() ? explanations_.path() : fs::path()};
  }

  std::vector<fs::path> pictures_;
  test::ScratchFolder explanations_;
};

TEST_P(DetectCommandTest, EachOfManyBrokenPicturesGivesItsLineAndItsExitCode) {
  ASSERT_GE(pictures_.size(), 50U);
  int whole = 0;
  for (const fs::path& picture : pictures_) {
    const Answered one = answer_for(options_for({picture}));
    ASSERT_EQ(one.lines.size(), 1U) << picture;
    const json& line = one.lines.front();
    EXPECT_EQ(line.at("image"), picture.string());
    EXPECT_NE(line.contains("points"), line.contains("error")) << line;
    EXPECT_EQ(one.code, line.contains("points") ? kWell : kUnreadable) << line;
    EXPECT_EQ(fs::exists(line.value("explanation", "")), explained() && line.contains("points")) << line;
    const bool frame_of_webcam = picture.filename() == "mjpeg.jpg";
    EXPECT_TRUE(!frame_of_webcam || one.code == kWell) << line;
    whole += line.contains("points") ? 1 : 0;
  }
  EXPECT_GE(whole, 1);
  EXPECT_LT(whole, 20);  // most are damaged by intent
}

TEST_P(DetectCommandTest, ABrokenPictureAmongOthersHidesNoneOfThem) {
  const Answered all = answer_for(options_for(pictures_));
  EXPECT_EQ(all.code, kUnreadable);
  EXPECT_EQ(all.lines.size(), pictures_.size());
}

INSTANTIATE_TEST_SUITE_P(Detectors, DetectCommandTest, testing::Values("led", "sphere", "apriltag"),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace tripoint
