// In place of libapriltag_decoder.cpp with TRIPOINT_APRILTAG=OFF.
#include <utility>

#include "tags/tag_decoder.h"

namespace tripoint {

struct TagLibrary {};

void TagLibraryEnd::operator()(TagLibrary* library) const { delete library; }

TagDecoder::TagDecoder(std::unique_ptr<TagLibrary, TagLibraryEnd> library) : library_(std::move(library)) {}

Result<TagDecoder> TagDecoder::open(std::string_view /*family*/) {
  return failure(ErrorCode::kMismatch,
                 "this program was built without AprilTags: build it with -DTRIPOINT_APRILTAG=ON (needs libapriltag)");
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): as the header has it
DecodedTags TagDecoder::decode(LumaCopy& /*luma*/) { return {}; }

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): as the header has it
TagShape TagDecoder::shape() const { return {}; }

}  // namespace tripoint
