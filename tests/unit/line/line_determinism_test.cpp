#include <vector>

#include <gtest/gtest.h>

#include "line/line.h"
#include "measurement_bytes.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::bytes_of;

std::vector<Event> eventful() {
  auto events = testing::shot(testing::webcam_model(), {testing::circle(250.0)}, testing::free_running());
  events.insert(events.begin() + 900, CameraLost{Side::kLeft, std::get<Observation>(events[899]).arrived});
  events.insert(events.begin() + 1000, Tick{std::get<Observation>(events[999]).arrived});
  return events;
}

TEST(LineDeterminismTest, TheSameEventsGiveTheSameBytes) {
  LineModel model = testing::webcam_model();
  model.covariance.diagonal().setConstant(1e-4);
  const auto events = eventful();
  const auto first = testing::verdicts(model, events);
  const auto second = testing::verdicts(model, events);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 2000U);
  for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(bytes_of(first[i]), bytes_of(second[i])) << i;
}

TEST(LineDeterminismTest, ABitOfOneEventShowsInTheBytes) {
  const LineModel model = testing::webcam_model();
  auto events = eventful();
  const auto first = testing::verdicts(model, events);
  auto& changed = std::get<Observation>(events[500]);
  changed.points[0].at.u_px = std::nextafter(changed.points[0].at.u_px, 1e9);
  const auto second = testing::verdicts(model, events);
  ASSERT_EQ(first.size(), second.size());
  bool differs = false;
  for (std::size_t i = 0; i < first.size(); ++i) differs = differs || bytes_of(first[i]) != bytes_of(second[i]);
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace tripoint
