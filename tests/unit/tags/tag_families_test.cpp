// Every family of libapriltag: its own picture of a tag, drawn as a camera sees it.
#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "drawn_tag.h"
#include "tags/tag_detector.h"

namespace tripoint {
namespace {

struct Family {
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

/// Versions of the library differ in the type of the index.
template <typename Index>
image_u8_t* pictured(image_u8_t* (*make)(apriltag_family_t*, Index), apriltag_family_t* family, int id) {
  return make(family, static_cast<Index>(id));
}

/// The picture that the library would print, a pixel a cell.
test::TagCells cells_of(const Family& family, int id) {
  apriltag_family_t* const made = family.create();
  image_u8_t* const picture = pictured(apriltag_to_image, made, id);
  test::TagCells cells{{}, made->width_at_border};
  for (int y = 0; y < picture->height; ++y) {
    cells.light.emplace_back();
    for (int x = 0; x < picture->width; ++x) cells.light.back().push_back(picture->buf[y * picture->stride + x] > 127);
  }
  std::free(picture->buf);
  std::free(picture);
  family.destroy(made);
  return cells;
}

class TagFamiliesTest : public testing::TestWithParam<Family> {};

TEST_P(TagFamiliesTest, ItsTagsAreFoundAndMeasured) {
  Result<TagDetector> detector = TagDetector::open({.family = GetParam().name});
  ASSERT_TRUE(detector) << detector.error().message;
  const Matrix3 tilted = Eigen::AngleAxisd(0.4, Vec3(1.0, 0.5, 0.2).normalized()).toRotationMatrix();
  const Matrix3 pixels_from_tag = test::seen_by_camera(tilted, {3.0, -5.0, 400.0}, 60.0);
  for (const int id : {0, 29}) {
    test::Sheet sheet;
    sheet.draw(cells_of(GetParam(), id), pixels_from_tag);
    sheet.add_noise(1.0);
    const SeenTags seen = detector->detect(sheet.grey());
    ASSERT_EQ(seen.tags.size(), 1U) << id;
    EXPECT_EQ(seen.tags[0].decoded.id, id);
    ASSERT_EQ(seen.tags[0].outline.cause, TagCause::kKept) << name(seen.tags[0].outline.cause);
    const auto truth = test::corners_of(pixels_from_tag);
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      EXPECT_NEAR(seen.tags[0].outline.corners_px[k].u_px, truth[k].x(), 0.06) << id;
      EXPECT_NEAR(seen.tags[0].outline.corners_px[k].v_px, truth[k].y(), 0.06) << id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, TagFamiliesTest,
                         testing::Values(Family{"tag36h11", tag36h11_create, tag36h11_destroy},
                                         Family{"tag16h5", tag16h5_create, tag16h5_destroy},
                                         Family{"tag25h9", tag25h9_create, tag25h9_destroy},
                                         Family{"tag36h10", tag36h10_create, tag36h10_destroy},
                                         Family{"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
                                         Family{"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
                                         Family{"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
                                         Family{"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
                                         Family{"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy}),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tripoint
