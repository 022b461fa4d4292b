#include <apriltag/apriltag.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tags/libapriltag_families.h"
#include "tags/tag_decoder.h"

namespace tripoint {
namespace {

constexpr double kMostTable_bytes = 16.0 * 1024 * 1024;
constexpr double kTableEntry_bytes = 3 * 16;    // the library keeps its table a third full, 16 bytes an entry
constexpr double kMostByChance = 1.0 / 5000.0;  // of the squares in a picture that are no tags
constexpr int kSmallestSide_px = 32;     // the library's threshold looks at whole tiles of 4 px and their neighbours
constexpr double kPixelCentre_px = 0.5;  // its pixel centres lie at halves, ours at integers

/// How many wrong bits the decoder may correct, 0 or 1.
int bits_to_correct(const apriltag_family_t& family) {
  const double codes = family.ncodes;
  const double words = codes * (1.0 + family.nbits);  // each code, and each with one wrong bit
  const bool small = words * kTableEntry_bytes <= kMostTable_bytes;
  const bool rare = 4.0 * words / std::exp2(family.nbits) <= kMostByChance;  // a square is read in four directions
  return small && rare ? 1 : 0;
}

DecodedTag decoded(const apriltag_detection_t& found) {
  DecodedTag tag;
  tag.id = found.id;
  tag.corrected_bits = found.hamming;
  tag.margin = static_cast<double>(found.decision_margin);
  for (std::size_t corner = 0; corner < kTagCorners; ++corner) {
    tag.corners_px[corner] = {found.p[corner][0] - kPixelCentre_px, found.p[corner][1] - kPixelCentre_px};
  }
  return tag;
}

}  // namespace

struct TagLibrary {
  apriltag_family_t* family = nullptr;
  void (*destroy_family)(apriltag_family_t*) = nullptr;
  apriltag_detector_t* detector = nullptr;
  std::vector<int> ids;  // none: all
};

namespace {

/// Places in the list of what was found.
std::vector<int> wanted(const zarray_t& found, const std::vector<int>& ids) {
  std::vector<int> places;
  for (int i = 0; i < zarray_size(&found); ++i) {
    apriltag_detection_t* one = nullptr;
    zarray_get(&found, i, static_cast<void*>(&one));
    if (ids.empty() || std::find(ids.begin(), ids.end(), one->id) != ids.end()) places.push_back(i);
  }
  return places;
}

}  // namespace

void TagLibraryEnd::operator()(TagLibrary* library) const {
  apriltag_detector_destroy(library->detector);
  library->destroy_family(library->family);
  delete library;
}

TagDecoder::TagDecoder(std::unique_ptr<TagLibrary, TagLibraryEnd> library) : library_(std::move(library)) {}

Result<TagDecoder> TagDecoder::open(std::string_view family, std::span<const int> ids) {
  const Result<NamedFamily> named = family_named(family);
  if (!named) return tl::make_unexpected(named.error());
  std::unique_ptr<TagLibrary, TagLibraryEnd> library(
      new TagLibrary{named->create(), named->destroy, apriltag_detector_create(), {ids.begin(), ids.end()}});
  library->detector->nthreads = 1;
  library->detector->quad_decimate = 1.0F;
  library->detector->refine_edges = false;  // corners are measured anew by the edges
  apriltag_detector_add_family_bits(library->detector, library->family, bits_to_correct(*library->family));
  return TagDecoder(std::move(library));
}

DecodedTags TagDecoder::decode(LumaCopy& luma) {
  DecodedTags decoded_tags;
  const ImageSize size = luma.size();
  if (std::min(size.width_px, size.height_px) < kSmallestSide_px) return decoded_tags;
  image_u8_t picture{size.width_px, size.height_px, size.width_px, luma.values().data()};
  zarray_t* const found = apriltag_detector_detect(library_->detector, &picture);
  for (const int i : wanted(*found, library_->ids)) {
    apriltag_detection_t* one = nullptr;
    zarray_get(found, i, static_cast<void*>(&one));
    if (!decoded_tags.tags.try_push_back(decoded(*one))) decoded_tags.cut = true;
  }
  apriltag_detections_destroy(found);
  return decoded_tags;
}

TagShape TagDecoder::shape() const {
  return {library_->family->width_at_border, library_->family->reversed_border,
          static_cast<int>(library_->family->ncodes)};
}

}  // namespace tripoint
