#include "tags/tag_detector.h"

#include <utility>

namespace tripoint {
Result<TagDetector> TagDetector::open(const TagDetectorSettings& settings) {
  return TagDecoder::open(settings.family, settings.ids).map([&](TagDecoder decoder) {
    return TagDetector(std::move(decoder), settings.min_margin);
  });
}

TagDetector::TagDetector(TagDecoder decoder, double min_margin)
    : decoder_(std::move(decoder)), min_margin_(min_margin) {}

SeenTags TagDetector::detect(const Picture& picture) {
  luma_.take(picture);
  const DecodedTags decoded = decoder_.decode(luma_);
  SeenTags seen;
  seen.cut = decoded.cut;
  seen.mean_luma = luma_.mean();
  for (const DecodedTag& tag : decoded.tags) {
    const bool sure = tag.margin >= min_margin_;
    seen.tags.push_back(
        {tag, sure ? tag_outline(luma_, tag, decoder_.shape()) : rough_outline(tag, TagCause::kUnsureBits)});
  }
  return seen;
}

}  // namespace tripoint
