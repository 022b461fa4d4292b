#include "explain/label_layout.h"

#include <gtest/gtest.h>

#include <random>

namespace tripoint {
namespace {

constexpr Box kRoom{0.0, 0.0, 999.0, 999.0};

Label label_at(double x, double y) { return {{{x, y}, 7.0}, 120.0, 17.0}; }

std::vector<Mark> marks_of(const std::vector<Label>& labels) {
  std::vector<Mark> marks;
  for (const Label& label : labels) marks.push_back(label.mark);
  return marks;
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Box box_of(const Mark& mark) {
  return {mark.at.x - mark.reach_px, mark.at.y - mark.reach_px, mark.at.x + mark.reach_px, mark.at.y + mark.reach_px};
}

TEST(LabelLayoutTest, ALoneLabelIsCloseToTheRightOfItsMark) {
  const std::vector<Label> labels{label_at(500.0, 500.0)};
  const auto places = places_of(labels, kRoom, marks_of(labels));
  ASSERT_TRUE(places[0]);
  EXPECT_GT(places[0]->left, 507.0);
  EXPECT_LT(places[0]->left, 515.0);
  EXPECT_DOUBLE_EQ(0.5 * (places[0]->top + places[0]->bottom), 500.0);
}

TEST(LabelLayoutTest, AtTheRightBorderItIsOnTheLeft) {
  const std::vector<Label> labels{label_at(995.0, 500.0)};
  const auto places = places_of(labels, kRoom, marks_of(labels));
  ASSERT_TRUE(places[0]);
  EXPECT_LT(places[0]->right, 988.0);
}

TEST(LabelLayoutTest, InEveryCornerThereIsAPlace) {
  for (const double x : {0.0, 999.0}) {
    for (const double y : {0.0, 999.0}) {
      const std::vector<Label> labels{label_at(x, y)};
      EXPECT_TRUE(places_of(labels, kRoom, marks_of(labels))[0]) << x << ", " << y;
    }
  }
}

TEST(LabelLayoutTest, NothingOfFiveHundredHidesAnotherOrAMark) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same marks each time
  std::uniform_real_distribution<double> place(0.0, 999.0);
  std::vector<Label> labels;
  for (int i = 0; i < 500; ++i) labels.push_back(label_at(place(random), place(random)));
  const std::vector<Mark> marks = marks_of(labels);
  const auto places = places_of(labels, kRoom, marks);
  int placed = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    ++placed;
    EXPECT_GE(places[i]->left, kRoom.left);
    EXPECT_LE(places[i]->right, kRoom.right);
    EXPECT_GE(places[i]->top, kRoom.top);
    EXPECT_LE(places[i]->bottom, kRoom.bottom);
    for (const Mark& mark : marks) EXPECT_FALSE(overlap(*places[i], box_of(mark)));
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(places[j] && overlap(*places[i], *places[j]));
  }
  EXPECT_GT(placed, 20);
  EXPECT_LT(placed, 500);  // 500 labels of 120 x 17 px would cover the whole picture
}

TEST(LabelLayoutTest, TheFirstLabelGetsThePlaceThatTwoWant) {
  const Box narrow{0.0, 490.0, 999.0, 510.0};
  const std::vector<Label> labels{label_at(800.0, 500.0), label_at(830.0, 500.0), label_at(860.0, 500.0)};
  const auto places = places_of(labels, narrow, marks_of(labels));
  EXPECT_TRUE(places[0]);
  EXPECT_FALSE(places[2] && places[1]);
}

}  // namespace
}  // namespace tripoint
