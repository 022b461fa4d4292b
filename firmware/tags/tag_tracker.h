// The tags of one camera's pictures: decoded now and then, followed by their edges in between.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tags/tag_detector.h"

namespace tripoint {

/// Between two decodes a tag is looked for only where its last two pictures foresee it, and must show there all that a
/// decoded tag must: straight edges, even light, cells and bits in their places. What is elsewhere goes unnoticed, so a
/// picture is decoded whole
///   - at least as every fifth by the driver's numbers, and after more than two dropped frames;
///   - when the last whole picture showed no tag, one that could not be measured, one twice, or more than there is room
///     for;
///   - at once when a tag is not found where it is foreseen: none is lost that a decode would show.
/// What it sees depends on the pictures alone and their numbers.
class TagTracker {
 public:
  /// @return as TagDecoder::open
  static Result<TagTracker> open(const TagDetectorSettings& settings);

  /// As TagDetector has it.
  [[nodiscard]] int ids() const { return detector_.ids(); }

  /// @param picture  whole, of any pixel format; the next one of this camera. One whose number does not grow is decoded
  /// @return valid until the next picture
  const SeenTags& see(const Picture& picture);

 private:
  /// How a tag's corners moved from one frame to the next, as of one.
  struct Way {
    std::uint32_t frame = 0;
    std::array<Vec2, kTagCorners> steps_px{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  };
  struct Last {
    std::uint32_t frame = 0;
    std::uint32_t whole_frame = 0;
    ImageSize size;
  };

  explicit TagTracker(TagDetector detector) : detector_(std::move(detector)) {}
  [[nodiscard]] bool may_follow(const Picture& picture) const;
  bool follow(const Picture& picture);
  void decode(const Picture& picture);
  [[nodiscard]] Way way_to(const SeenTag& tag, std::uint32_t frame) const;

  TagDetector detector_;
  SeenTags seen_;
  FixedVector<Way, kMaxDecodedTags> ways_;  // of seen_.tags
  std::optional<Last> last_;
};

}  // namespace tripoint
