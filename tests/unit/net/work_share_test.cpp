#include "net/work_share.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr Duration kPiece{100'000};

/// A thread that does pieces of work as told, on a processor of its own.
class Worker {
 public:
  /// Works without a pause but those that it has to take.
  void work_for(Duration wall) {
    for (const TimePoint end = now_ + wall; now_ < end;) {
      worked_ += kPiece;
      now_ += kPiece;
      const Duration rest = share_.rest_after(worked_, now_);
      longest_rest_ = std::max(longest_rest_, rest);
      now_ += rest;
    }
  }
  void wait_for(Duration wall) { now_ += wall; }

  [[nodiscard]] Duration worked() const { return worked_; }
  [[nodiscard]] Duration longest_rest() const { return longest_rest_; }

 private:
  WorkShare share_;
  Duration worked_{0};
  TimePoint now_ = time_from_ns(5'000'000'000);
  Duration longest_rest_{0};
};

TEST(WorkShareTest, WhoeverIsAlwaysAskedWorksForHalfOfTheTime) {
  Worker worker;
  worker.work_for(std::chrono::seconds(10));
  EXPECT_NEAR(static_cast<double>(worker.worked().count()), 5e9, 1e7);
}

TEST(WorkShareTest, ARestIsShort) {
  Worker worker;
  worker.work_for(std::chrono::seconds(10));
  EXPECT_GT(worker.longest_rest(), Duration{0});
  EXPECT_LE(worker.longest_rest(), 2 * (WorkShare::kWorthARest + kPiece));
}

TEST(WorkShareTest, WhoeverWorksForLessNeverRests) {
  Worker worker;
  for (int i = 0; i < 1000; ++i) {
    worker.work_for(std::chrono::milliseconds(1));
    worker.wait_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(worker.longest_rest(), Duration{0});
}

TEST(WorkShareTest, AQuietHourDoesNotPayForMoreThanAMoment) {
  Worker worker;
  worker.work_for(std::chrono::seconds(1));
  const Duration before = worker.worked();
  worker.wait_for(std::chrono::hours(1));
  worker.work_for(std::chrono::milliseconds(100));
  EXPECT_LE(worker.worked() - before, std::chrono::milliseconds(50) + WorkShare::kMostSaved + WorkShare::kWorthARest);
}

TEST(WorkShareTest, WaitingForTheProcessorIsNotWork) {
  WorkShare share;
  TimePoint now = time_from_ns(1);
  for (int i = 0; i < 1000; ++i) {
    now += 3 * kPiece;  // others had two thirds of it
    EXPECT_EQ(share.rest_after((i + 1) * kPiece, now), Duration{0});
  }
}

}  // namespace
}  // namespace tripoint
