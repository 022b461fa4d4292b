// A driver with one camera behind it that does what a test says.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "devices/v4l2_driver.h"
#include "ports/clock.h"

namespace tripoint::test {

/// Time passes only while the driver waits.
class WaitingClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
  [[nodiscard]] bool synchronised() const override { return false; }
  void pass(Duration duration) { now_ += duration; }

 private:
  TimePoint now_ = time_from_ns(10'000'000'000);
};

struct FakeControl {
  int minimum = 0;
  int maximum = 0;
  int value = 0;
  bool stuck = false;  ///< accepts and ignores what is written
};

struct FakeFrame {
  std::uint32_t sequence = 0;
  std::uint8_t value = 0;
  std::uint32_t missing_bytes = 0;
  bool damaged = false;
  std::int64_t stamp_us = 0;
  bool monotonic = true;
  bool lost_after = false;  ///< the next DQBUF fails with EIO
};

/// Frames that become ready during one wait; before them the time that passes.
struct FakeWait {
  Duration after{0};
  std::vector<FakeFrame> frames = {};
  int events = 1;  ///< POLLIN
};

class FakeV4l2Driver final : public V4l2Driver {
 public:
  explicit FakeV4l2Driver(WaitingClock& clock);

  int open(const std::filesystem::path& node) override;
  int control(int fd, unsigned long request, void* argument) override;
  int wait(int fd, Duration limit) override;
  void* map(int fd, std::size_t length, std::int64_t offset) override;
  [[nodiscard]] StampPoint stamp_point() const override { return stamps; }

  std::map<unsigned long, int> failures;  ///< request -> -errno
  int open_failure = 0;
  StampPoint stamps = StampPoint::kFirstByte;
  bool map_fails = false;
  std::uint32_t capabilities = 0;  ///< of the node; set to a camera's at construction
  std::uint32_t buffers_given = 4;
  std::uint32_t width = 640, height = 480, fourcc = 0, padding_bytes = 0;  ///< the only format
  std::uint32_t field = 1;                                                 ///< V4L2_FIELD_NONE: whole pictures
  std::uint32_t rate_numerator = 333'333, rate_denominator = 10'000'000;
  std::map<std::uint32_t, FakeControl> controls;
  std::deque<FakeWait> waits;  ///< after them every wait lasts its whole limit

  std::vector<std::string> log;  ///< open, on, off
  [[nodiscard]] std::size_t buffers_with_driver() const { return queued_.size(); }

 private:
  int describe_capability(void* argument);
  int set_format(void* argument);
  int set_rate(void* argument);
  int offer_format(void* argument);
  int offer_size(void* argument);
  int offer_rate(void* argument);
  int describe_control(void* argument);
  int set_control(void* argument);
  int read_control(void* argument);
  int give_buffers(void* argument);
  int describe_buffer(void* argument);
  int queue(void* argument);
  int dequeue(void* argument);
  [[nodiscard]] std::uint32_t row_bytes() const;  ///< MJPEG: as many as its largest pictures could take
  [[nodiscard]] std::uint32_t image_bytes() const;

  WaitingClock& clock_;
  std::vector<void*> memory_;
  std::deque<std::uint32_t> queued_;
  std::deque<FakeFrame> ready_;
  bool lost_ = false;
};

}  // namespace tripoint::test
