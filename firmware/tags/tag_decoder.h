// Which tags of a family a picture shows, and roughly where: libapriltag behind a narrow door.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "tags/luma_copy.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/pixel.h"
#include "values/result.h"

namespace tripoint {

/// Corners are those of the square whose inside and outside differ: lower left, lower right, upper right and upper left
/// of the tag as its picture stands upright. In the tag's frame (x right, y down, z into the tag; size 2) these are
/// (-1, 1), (1, 1), (1, -1), (-1, -1). A camera that sees the front of the tag sees them run counter-clockwise.
struct DecodedTag {
  int id = 0;
  int corrected_bits = 0;
  double margin = 0.0;                           ///< mean distance of the bits from the threshold, luma steps
  std::array<RawPixel, kTagCorners> corners_px;  ///< to about a pixel
};

inline constexpr std::size_t kMaxDecodedTags = 64;
struct DecodedTags {
  FixedVector<DecodedTag, kMaxDecodedTags> tags;  ///< by id
  bool cut = false;                               ///< there were more
};

/// What the edges of a family's tags look like.
struct TagShape {
  int cells_across = 8;       ///< of the square with the four corners
  bool light_inside = false;  ///< just within its edges; just outside it is the other way round
  int ids = 0;                ///< from 0
};

struct TagLibrary;
struct TagLibraryEnd {
  void operator()(TagLibrary* library) const;
};

/// The library allocates in every call, in proportion to the picture; it gives all of it back.
class TagDecoder {
 public:
  /// One wrong bit is corrected where that neither costs more than 16 MiB nor lets chance find a tag in more than one
  /// of 5000 squares; otherwise none.
  ///
  /// @param family  as libapriltag names it, for example tag36h11
  /// @param ids     that are wanted; others leave them their room. None: all
  /// @return kOutOfRange when it has no such family, naming those it has; kMismatch when the program was built without
  /// it
  static Result<TagDecoder> open(std::string_view family, std::span<const int> ids = {});

  /// @param luma  not changed
  DecodedTags decode(LumaCopy& luma);
  [[nodiscard]] TagShape shape() const;

 private:
  explicit TagDecoder(std::unique_ptr<TagLibrary, TagLibraryEnd> library);
  std::unique_ptr<TagLibrary, TagLibraryEnd> library_;
};

}  // namespace tripoint
