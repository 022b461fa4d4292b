#include "explain/heading.h"

#include <gtest/gtest.h>

#include "explain/finding.h"

namespace tripoint {
namespace {

Finding finding_of(DropCause cause) {
  Finding finding;
  finding.candidate.cause = cause;
  return finding;
}

std::vector<Finding> all_causes(std::size_t of_each) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < of_each * kDropCauseNames.size(); ++i) {
    findings.push_back(finding_of(static_cast<DropCause>(i % kDropCauseNames.size())));
  }
  return findings;
}

TEST(HeadingTest, TheMostFrequentCauseIsNamedFirst) {
  const std::vector<Finding> findings{finding_of(DropCause::kKept), finding_of(DropCause::kDim),
                                      finding_of(DropCause::kNotRed), finding_of(DropCause::kNotRed)};
  EXPECT_EQ(tally_of_dropped(findings), "2 not red, 1 dim");
}

TEST(HeadingTest, NothingDroppedIsNothingCounted) { EXPECT_EQ(tally_of_dropped({}), ""); }

TEST(HeadingTest, ItIsAsHighAsWhatItSays) {
  Heading short_one;
  short_one.title = "a.png";
  short_one.size = "640 x 480 px";
  Heading long_one = short_one;
  long_one.title = std::string(1000, 'm');
  long_one.notes = {"one", "two"};
  long_one.causes = tally_of_dropped(all_causes(12));
  const RgbImage low = heading_of(short_one, 800);
  const RgbImage high = heading_of(long_one, 800);
  EXPECT_EQ(low.size.width_px, 800);
  EXPECT_EQ(low.values.size(), low.index(0, low.size.height_px));
  EXPECT_GE(high.size.height_px, low.size.height_px + 3 * 20);  // two notes, and causes on more than one line
}

}  // namespace
}  // namespace tripoint
