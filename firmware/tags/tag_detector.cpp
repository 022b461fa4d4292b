#include "tags/tag_detector.h"

#include <utility>

#include "tags/tag_print.h"
#include "values/assert.h"

namespace tripoint {
Result<TagDetector> TagDetector::open(const TagDetectorSettings& settings) {
  return TagDecoder::open(settings.family, settings.ids).map([&](TagDecoder decoder) {
    return TagDetector(std::move(decoder), settings);
  });
}

TagDetector::TagDetector(TagDecoder decoder, const TagDetectorSettings& settings)
    : decoder_(std::move(decoder)), family_(settings.family), min_margin_(settings.min_margin) {}

const TagPattern& TagDetector::pattern(int id) {
  const auto known = patterns_.find(id);
  if (known != patterns_.end()) return known->second;
  const Result<TagCells> cells = tag_print(family_, id);
  TRIPOINT_ASSERT(cells.has_value());
  return patterns_.emplace(id, pattern_of(*cells)).first->second;
}

SeenTags TagDetector::detect(const Picture& picture) {
  luma_.take(picture);
  const DecodedTags decoded = decoder_.decode(luma_);
  SeenTags seen;
  seen.cut = decoded.cut;
  seen.mean_luma = luma_.mean();
  for (const DecodedTag& tag : decoded.tags) {
    const bool sure = tag.margin >= min_margin_;
    seen.tags.push_back(
        {tag, sure ? tag_outline(luma_.view(), tag, pattern(tag.id)) : rough_outline(tag, TagCause::kUnsureBits)});
  }
  return seen;
}

}  // namespace tripoint
