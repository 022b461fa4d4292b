// What one camera saw last: a bounded ring of pictures whose points are linked from one to the next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "line/align/association.h"
#include "line/observation.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

struct TrackedPicture {
  std::uint32_t frame = 0;
  Duration line_time{0};
  std::optional<Duration> exposure;  ///< absent = the camera does not say
  double first_row_px = 0.0;         ///< highest row with a point; of an empty picture that of the picture before
  bool frames_dropped = false;       ///< the driver's numbers have a gap before it
  bool broken = false;               ///< a point was not a number and was left out
  bool unwatched = false;            ///< shows points, but elsewhere there may be others: see Track
  ImageHealth health;
  FixedVector<ImagePoint, kMaxImagePoints> points;
  FixedVector<Link, kMaxImagePoints> links;    ///< to the picture before, one for each point
  FixedVector<Vec2, kMaxImagePoints> step_px;  ///< motion from one frame to the next; zero when unlinked
};

/// A picture seen by regions is trusted for what it does not show only as long as the last whole picture is one of the
/// kFramesPerWhole - 1 before it, was looked at to the end, and held no more points than the regions do.
class Track {
 public:
  /// Pictures kept: at 30 fps as far as one camera can run ahead of the other before it counts as silent.
  static constexpr std::size_t kKept = 8;

  /// A number that does not grow begins a new track.
  void take(const Observation& seen);
  void clear() {
    size_ = 0;
    whole_.reset();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// @param back  0 is the newest
  [[nodiscard]] const TrackedPicture& picture(std::size_t back) const;

 private:
  struct Whole {
    std::uint32_t frame = 0;
    std::size_t points = 0;
    bool to_the_end = false;
  };

  TrackedPicture& slot(std::size_t back) { return ring_[(newest_ + kKept - back) % kKept]; }
  void link_to_picture_before(TrackedPicture& now) const;

  [[nodiscard]] bool watched(const TrackedPicture& regions) const;

  std::array<TrackedPicture, kKept> ring_{};
  std::optional<Whole> whole_;  // the last one
  std::size_t newest_ = 0;
  std::size_t size_ = 0;
};

}  // namespace tripoint
