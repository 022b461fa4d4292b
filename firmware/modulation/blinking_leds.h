// One camera's lights: those that blink as the LEDs do are LEDs, and no others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "line/align/stamp_clock.h"
#include "line/observation.h"
#include "modulation/light_tracks.h"
#include "modulation/switch_log.h"
#include "modulation/switching_moment.h"
#include "ports/frame.h"
#include "values/latest.h"

namespace tripoint {

struct BlinkSettings {
  FixedVector<std::uint16_t, kMaxTargetPoints> leds;  ///< their ids, in the target's order
  Duration stamp_error{0};                            ///< how wrong a stamp may be against the clock of the lines
};

/// Why a spot of the last picture was believed or not.
enum class SpotVerdict : std::uint8_t {
  kLed,
  kAmbient,   ///< it is there when it must not be, or another light touches it
  kUnproven,  ///< not yet followed for long enough, or the picture was exposed while the LEDs were switched
};

class BlinkingLeds {
 public:
  /// Log and rhythm must outlive it.
  BlinkingLeds(const BlinkSettings& settings, const SwitchLog& log, Latest<std::optional<Rhythm>>& rhythm);

  /// The observation with the LEDs alone, each with its id, if all of them were lit in this picture, and otherwise
  /// marked as one in which nothing is to be seen. To be given every picture of the camera, seen whole.
  Observation sifted(const Observation& seen, const Picture& picture);

  /// One for each point that the last observation had; none when it repeated an earlier one.
  [[nodiscard]] const FixedVector<SpotVerdict, kMaxImagePoints>& verdicts() const { return verdicts_; }

 private:
  struct Rows {
    double first_px = 0.0;
    double last_px = 0.0;
  };

  [[nodiscard]] std::optional<LitLeds> lit_at(const Observation& seen, double row_px) const;
  [[nodiscard]] SpotVerdict verdict_of(const Observation& seen, std::size_t point) const;
  [[nodiscard]] Rows rows_of_interest(const Picture& picture) const;
  void tell_rhythm(const Observation& seen, const Rows& rows);
  [[nodiscard]] Observation with_leds_alone(Observation seen) const;

  BlinkSettings settings_;
  LedCode code_;
  const SwitchLog& log_;
  Latest<std::optional<Rhythm>>& rhythm_;
  StampClock clock_;
  LightTracks lights_;
  FixedVector<SpotVerdict, kMaxImagePoints> verdicts_;
  std::optional<std::uint32_t> last_frame_;
  std::uint32_t left_out_ = 0;
};

}  // namespace tripoint
