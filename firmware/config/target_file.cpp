#include "config/target_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "config/tag_places.h"
#include "config/target_shape.h"
#include "document/file.h"
#include "document/table_reader.h"

namespace tripoint {
namespace {

constexpr std::string_view kFormat = "tripoint-target/1";
constexpr std::size_t kMostMembers = 12;  // of the points block, registers 502 to 621
constexpr double kFarthest_mm = 1000.0;
constexpr Permitted<double> kPlaceMm{-10'000.0, 10'000.0};
constexpr Permitted<double> kRotationRad{-std::numbers::pi, std::numbers::pi};

template <typename Member>
bool new_id(const std::vector<Member>& members, int id) {
  return std::none_of(members.begin(), members.end(), [&](const Member& member) { return member.id == id; });
}

bool apart(const std::vector<TargetFilePoint>& points, const Vec3& position_mm) {
  return std::all_of(points.begin(), points.end(), [&](const TargetFilePoint& point) {
    const double distance_mm = (point.position_mm - position_mm).norm();
    return distance_mm >= kAlike_mm && distance_mm < kFarthest_mm;
  });
}

std::optional<Vec3> facing_from(TableReader& table) {
  if (!table.has("facing")) return std::nullopt;
  const Vec3 facing = table.vec3("facing", {-1000.0, 1000.0});
  if (!(facing.norm() > 1e-3)) {
    table.refuse("facing", "permitted is a direction, as [0, 0, 1]");
    return std::nullopt;
  }
  return facing.normalized();
}

std::vector<TargetFilePoint> points_from(TableReader& root) {
  std::vector<TargetFilePoint> points;
  for (TableReader& table : root.tables("points")) {
    TargetFilePoint point;
    point.id = static_cast<int>(table.integer("id", {1, 65'535}));
    point.position_mm = table.vec3("position_mm", kPlaceMm);
    point.uncertainty_mm = table.number("uncertainty_mm", {0.0, 10.0}, point.uncertainty_mm);
    point.facing = facing_from(table);
    if (!new_id(points, point.id)) table.refuse("id", "permitted is each id once");
    if (!apart(points, point.position_mm)) {
      table.refuse("position_mm", fmt::format("permitted is {} mm or more, and less than {} mm, from other points",
                                              kAlike_mm, kFarthest_mm));
    }
    table.finish();
    points.push_back(point);
  }
  if (points.empty() || points.size() > kMostMembers) root.refuse("points", "permitted is 1 to 12 points");
  if (points.size() == 1 && points.front().position_mm != Vec3::Zero()) {
    root.refuse("points", "permitted for a single point is position_mm = [0, 0, 0]: x, y, z mean the target's origin");
  }
  return points;
}

/// Beside other tags.
void check_place(TableReader& table, const std::vector<TargetFileTag>& tags, const TargetFileTag& added) {
  for (const TargetFileTag& tag : tags) {
    if (overlap(tag, added)) {
      table.refuse(
          "position_mm",
          fmt::format("permitted is no overlap with another tag, but tag {} and tag {} do: measure their places, "
                      "and size_mm without the light rim",
                      tag.id, added.id));
    } else if (farthest_mm(tag, added) >= kFarthest_mm) {
      table.refuse("position_mm",
                   fmt::format("permitted is less than {} mm from the corners of other tags", kFarthest_mm));
    } else {
      continue;
    }
    return;
  }
}

std::vector<TargetFileTag> tags_from(TableReader& root) {
  std::vector<TargetFileTag> tags;
  for (TableReader& table : root.tables("tags")) {
    TargetFileTag tag;
    tag.id = static_cast<int>(table.integer("id", {0, 65'535}));
    tag.size_mm = table.number("size_mm", {1.0, kFarthest_mm});
    tag.position_mm = table.vec3("position_mm", kPlaceMm);
    tag.rotation_rad = table.vec3("rotation_rad", kRotationRad);
    tag.uncertainty_mm = table.number("uncertainty_mm", {0.0, 10.0}, tag.uncertainty_mm);
    if (!new_id(tags, tag.id)) table.refuse("id", "permitted is each id once");
    if (farthest_mm(tag, tag) >= kFarthest_mm) {
      table.refuse("size_mm", fmt::format("permitted is less than {} mm from corner to corner", kFarthest_mm));
    }
    check_place(table, tags, tag);
    table.finish();
    tags.push_back(tag);
  }
  if (tags.empty() || tags.size() > kMostMembers) root.refuse("tags", "permitted is 1 to 12 tags");
  return tags;
}

/// To be asked when nothing else is wrong.
void check_shape(TableReader& root, const TargetFile& target) {
  std::vector<Vec3> places_mm;
  for (const TargetFilePoint& point : target.points) places_mm.push_back(point.position_mm);
  if (const auto fault = shape_fault(places_mm, target.facing)) root.refuse("points", *fault);
}

}  // namespace

TargetFile single_led() {
  TargetFile target;
  TargetFilePoint origin;
  origin.uncertainty_mm = 0.0;
  target.points.push_back(origin);
  target.sha256 = sha256("");
  return target;
}

Result<TargetFile> parse_target(std::string_view text, std::string_view file_name) {
  const Result<TomlTable> tree = toml_tree_from(text, file_name);
  if (!tree) return tl::make_unexpected(tree.error());
  Findings findings{std::string{file_name}};
  TableReader root{findings, *tree};
  root.choice<bool>("format", {{kFormat, true}});

  TargetFile target;
  target.kind = root.choice<TargetKind>("detector", {{"led", TargetKind::kLed}, {"apriltag", TargetKind::kAprilTag}});
  if (target.kind == TargetKind::kLed) {
    target.points = points_from(root);
    target.facing = facing_from(root);
  } else {
    target.family = root.text("family");
    target.tags = tags_from(root);
  }
  root.finish();
  if (!findings.error()) check_shape(root, target);
  if (findings.error()) return tl::make_unexpected(*findings.error());
  target.sha256 = sha256(text);
  return target;
}

Result<TargetFile> load_target(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kMostDocumentBytes);
  if (!text) return tl::make_unexpected(text.error());
  return parse_target(*text, path.string());
}

}  // namespace tripoint
