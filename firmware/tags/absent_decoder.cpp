// In place of libapriltag_decoder.cpp and libapriltag_print.cpp with TRIPOINT_APRILTAG=OFF.
#include <utility>

#include "tags/tag_decoder.h"
#include "tags/tag_print.h"

namespace tripoint {
namespace {

tl::unexpected<Error> built_without() {
  return failure(ErrorCode::kMismatch,
                 "this program was built without AprilTags: build it with -DTRIPOINT_APRILTAG=ON (needs libapriltag)");
}

}  // namespace

struct TagLibrary {};

void TagLibraryEnd::operator()(TagLibrary* library) const { delete library; }

TagDecoder::TagDecoder(std::unique_ptr<TagLibrary, TagLibraryEnd> library) : library_(std::move(library)) {}

Result<TagDecoder> TagDecoder::open(std::string_view /*family*/, std::span<const int> /*ids*/) {
  return built_without();
}

Result<TagCells> tag_print(std::string_view /*family*/, int /*id*/) { return built_without(); }

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): as the header has it
DecodedTags TagDecoder::decode(LumaCopy& /*luma*/) { return {}; }

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): as the header has it
TagShape TagDecoder::shape() const { return {}; }

}  // namespace tripoint
