// AprilTags in a picture: decoded by libapriltag, measured by their edges.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "line/observation.h"
#include "ports/frame.h"
#include "tags/luma_copy.h"
#include "tags/tag_decoder.h"
#include "tags/tag_near.h"
#include "tags/tag_pattern.h"
#include "values/fixed_vector.h"
#include "values/result.h"

namespace tripoint {

struct TagDetectorSettings {
  std::string family = "tag36h11";
  /// Luma steps. Below lie squares that chance makes a tag.
  double min_margin = 25.0;
  /// Of the tags that are looked for; others are as if not there. None: all of the family.
  std::vector<int> ids{};
};

struct SeenTags {
  FixedVector<SeenTag, kMaxDecodedTags> tags;  ///< by id; the same id may be there more than once
  bool cut = false;                            ///< there were more
  double mean_luma = 0.0;                      ///< of the last picture that was decoded
  Coverage coverage = Coverage::kWholeFrame;   ///< of this one
};

/// Room for pictures of one size; allocates when it changes or a tag is seen for the first time, and libapriltag in
/// every picture.
class TagDetector {
 public:
  /// @return as TagDecoder::open
  static Result<TagDetector> open(const TagDetectorSettings& settings);

  /// How many tags the family has, their ids from 0.
  [[nodiscard]] int ids() const { return decoder_.shape().ids; }

  /// @param picture  whole, of any pixel format: only its luma is read
  SeenTags detect(const Picture& picture);

  /// What a tag of the family shows.
  ///
  /// @param id  that the family has
  const TagPattern& pattern(int id);
  [[nodiscard]] double min_margin() const { return min_margin_; }

 private:
  TagDetector(TagDecoder decoder, const TagDetectorSettings& settings);

  TagDecoder decoder_;
  std::string family_;
  std::map<int, TagPattern> patterns_;  // of the tags that were seen
  double min_margin_;
  LumaCopy luma_;
};

}  // namespace tripoint
