#include "modulation/led_switcher.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace tripoint {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(30);

class SetClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return time; }
  [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
  [[nodiscard]] bool synchronised() const override { return false; }
  TimePoint time{std::chrono::seconds(100)};
};

/// What all lines did, and whether the next call fails.
struct Wires {
  std::vector<bool> lit;
  bool broken = false;
};

class Wire final : public SwitchedLine {
 public:
  Wire(Wires& wires, std::size_t led) : wires_(wires), led_(led) { wires_.lit.push_back(false); }
  Result<void> set(bool lit) override {
    if (wires_.broken) return failure(ErrorCode::kDeviceFault, "gone");
    wires_.lit[led_] = lit;
    return {};
  }

 private:
  Wires& wires_;
  std::size_t led_;
};

/// A switcher on a clock that moves only by waiting.
struct Switching {
  explicit Switching(std::size_t leds) {
    SwitchedLines lines;
    for (std::size_t led = 0; led < leds; ++led) lines.push_back(std::make_unique<Wire>(wires, led));
    switcher.emplace(std::move(lines),
                     SwitcherLinks{.log = log,
                                   .rhythms = rhythms,
                                   .clock = clock,
                                   .wait_until = [this](TimePoint until) { clock.time = until; },
                                   .say = [this](std::string_view what) { said.emplace_back(what); }});
  }
  /// Both cameras expose at whole periods, `apart` from each other.
  void expose(Duration half, Duration apart = Duration{0}) {
    const TimePoint middle{kPeriod * (clock.time.time_since_epoch() / kPeriod)};
    rhythms.left.put(Rhythm{middle, kPeriod, half});
    rhythms.right.put(Rhythm{middle + apart, kPeriod, half});
  }

  SetClock clock;
  Wires wires;
  SwitchLog log;
  PerSide<Latest<std::optional<Rhythm>>> rhythms;
  std::vector<std::string> said;
  std::optional<LedSwitcher> switcher;
};

TEST(LedSwitcherTest, WithoutACameraAllAreLit) {
  Switching unit(2);
  unit.switcher->step();
  EXPECT_EQ(unit.wires.lit, (std::vector<bool>{true, true}));
}

TEST(LedSwitcherTest, EveryExposureSeesOneStepOfTheCode) {
  Switching unit(3);
  const LedCode code(3);
  std::vector<LitLeds> seen;
  for (int i = 0; i < 30; ++i) {
    unit.expose(std::chrono::milliseconds(5), std::chrono::milliseconds(9));
    const TimePoint before = unit.clock.time;
    unit.switcher->step();
    const TimePoint middle{kPeriod * (before.time_since_epoch() / kPeriod)};
    for (const Duration apart : {Duration{0}, Duration{std::chrono::milliseconds(9)}}) {
      const TimePoint at = middle + kPeriod + apart;
      const auto lit = unit.log.during(at - std::chrono::milliseconds(5), at + std::chrono::milliseconds(5));
      if (i <= 2 || at + std::chrono::milliseconds(5) >= unit.clock.time) continue;
      EXPECT_TRUE(lit) << i;
    }
    const std::vector<bool> wires = unit.wires.lit;
    for (std::size_t led = 0; led < 3; ++led) {
      EXPECT_EQ(wires[led], code.lit_in(static_cast<std::uint64_t>(i)).contains(led)) << i;
    }
  }
}

TEST(LedSwitcherTest, AFailedLineIsSaidOnceAndLeavesNothingKnownUntilItWorks) {
  Switching unit(1);
  unit.wires.broken = true;
  for (int i = 0; i < 3; ++i) {
    unit.expose(std::chrono::milliseconds(2));
    unit.switcher->step();
  }
  EXPECT_FALSE(unit.log.during(unit.clock.time, unit.clock.time));
  ASSERT_EQ(unit.said.size(), 1U);
  EXPECT_EQ(unit.said[0], "modulation: line of LED 1: gone");
  unit.wires.broken = false;
  unit.expose(std::chrono::milliseconds(2));
  unit.switcher->step();
  EXPECT_TRUE(unit.log.during(unit.clock.time, unit.clock.time));
  EXPECT_EQ(unit.said.size(), 2U);
}

TEST(LedSwitcherTest, ExposuresThatLeaveNoTimeAreSaidOnce) {
  Switching unit(1);
  for (int i = 0; i < 3; ++i) {
    unit.expose(std::chrono::milliseconds(9), std::chrono::milliseconds(15));
    unit.switcher->step();
  }
  ASSERT_EQ(unit.said.size(), 1U);
  EXPECT_NE(unit.said[0].find("a shorter exposure helps"), std::string::npos);
}

TEST(LedSwitcherTest, WhenItIsStoppedTheLedsGoOut) {
  Switching unit(2);
  unit.switcher->step();
  std::stop_source stop;
  stop.request_stop();
  unit.switcher->run(stop.get_token());
  EXPECT_EQ(unit.wires.lit, (std::vector<bool>{false, false}));
}

}  // namespace
}  // namespace tripoint
