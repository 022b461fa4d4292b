#include "serve/publication.h"

#include <gtest/gtest.h>

#include <thread>

#include "serve/image.h"
#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

UnitState warning_state() {
  Measurement measurement = position_measurement();
  measurement.warnings.insert(Warning::kWeakSpot);
  UnitState state = unit_state(measurement);
  state.warnings.insert(Warning::kFramesDropped);
  return state;
}

TEST(PublicationTest, TheNewestStateWins) {
  Publication publication(unit_state(position_measurement(1)));
  publication.publish(unit_state(position_measurement(2)), kExposed);
  EXPECT_EQ(publication.newest(kExposed).state->newest->measurement.sequence, 2U);
}

TEST(PublicationTest, AnEditionInHandDoesNotChange) {
  Publication publication(unit_state(position_measurement(1)));
  const Edition edition = publication.newest(kExposed);
  publication.publish(unit_state(position_measurement(2)), kExposed);
  EXPECT_EQ(edition.state->newest->measurement.sequence, 1U);
}

TEST(PublicationTest, AWarningStaysTenSecondsAfterItsCause) {
  Publication publication(UnitState{});
  publication.publish(warning_state(), kExposed);
  publication.publish(unit_state(), kExposed + milliseconds(1));
  const auto warnings_at = [&](TimePoint now) {
    const RegisterImage image = image_at(publication.newest(now), ServiceState{}, now);
    return std::pair<unsigned, unsigned>(image[35], image[33] & 0x0020U);
  };
  const unsigned both = 1U << 1U | 1U << 5U;
  EXPECT_EQ(warnings_at(kExposed + std::chrono::seconds(10)), std::pair(both, 0x0020U));
  EXPECT_EQ(warnings_at(kExposed + std::chrono::seconds(10) + Duration{1}), std::pair(0U, 0U));
}

TEST(PublicationTest, AHeldWarningIsNotOneOfTheNewPose) {
  Publication publication(UnitState{});
  publication.publish(warning_state(), kExposed);
  publication.publish(unit_state(), kExposed);
  const RegisterImage image = image_at(publication.newest(kExposed), ServiceState{}, kExposed);
  EXPECT_EQ(image[103], 0);
  EXPECT_EQ(image[101] & 0x0020, 0);
}

TEST(PublicationTest, ReadersNeverSeeAMixtureOfTwoStates) {
  Publication publication(unit_state(position_measurement(0)));
  std::jthread writer([&](const std::stop_token& stop) {
    for (std::uint64_t sequence = 1; !stop.stop_requested(); ++sequence) {
      Measurement measurement = position_measurement(sequence);
      measurement.pose->position_in_output_mm.x() = 1e-3 * static_cast<double>(sequence % 1000);
      publication.publish(unit_state(measurement), kExposed);
    }
  });
  for (int i = 0; i < 20'000; ++i) {
    const Edition edition = publication.newest(kExposed);
    const RegisterImage image = image_at(edition, ServiceState{}, kExposed);
    ASSERT_EQ(image[100], image[147]);
    const std::uint32_t sequence = u32_at(image, 144);
    if (sequence == 0) continue;
    ASSERT_EQ(i32_at(image, 110), static_cast<std::int32_t>(sequence % 1000));
  }
}

}  // namespace
}  // namespace tripoint
