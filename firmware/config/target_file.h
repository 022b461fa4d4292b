// A target file as a checked value: which points or tags sit where on the tool.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/sha256.h"
#include "values/linear.h"
#include "values/result.h"

namespace tripoint {

enum class TargetKind : std::uint8_t { kLed, kAprilTag };

struct TargetFilePoint {
  int id = 1;
  Vec3 position_mm = Vec3::Zero();  ///< in the target's frame
  double uncertainty_mm = 0.05;     ///< k = 2
  std::optional<Vec3> facing;       ///< unit length, where this point shines another way than the target
};

/// Tag frame as in libapriltag: x right, y down, z into the tag.
struct TargetFileTag {
  int id = 0;
  double size_mm = 0.0;             ///< of the black square
  Vec3 position_mm = Vec3::Zero();  ///< of its centre
  Vec3 rotation_rad = Vec3::Zero();
  double uncertainty_mm = 0.05;  ///< k = 2, of each corner
};

struct TargetFile {
  TargetKind kind = TargetKind::kLed;
  std::vector<TargetFilePoint> points;  ///< 1 to 12 for LEDs, none for tags
  std::string family;                   ///< of the tags
  std::vector<TargetFileTag> tags;      ///< 1 to 12 for tags, none for LEDs
  std::optional<Vec3> facing;           ///< unit length: the side that shines; none for tags
  Sha256 sha256{};                      ///< of the whole file
};

/// One LED that is the target's origin, exactly: what an empty target.file means.
TargetFile single_led();

/// Reads format "tripoint-target/1".
///
/// @return kMalformed, kUnknownKey, kMissingKey or kOutOfRange naming file, line, key and what is permitted; ids are
///         unique, points lie apart but not far, a single one at the origin, three or more as `shape_fault` asks; tags
///         do not overlap, and are less than a metre from corner to corner
Result<TargetFile> parse_target(std::string_view text, std::string_view file_name);

/// @return kCannotRead, or as parse_target
Result<TargetFile> load_target(const std::filesystem::path& path);

}  // namespace tripoint
