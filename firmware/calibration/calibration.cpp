#include "calibration/calibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "calibration/covariance.h"
#include "calibration/integrity.h"
#include "document/file.h"
#include "document/table_reader.h"

namespace tripoint {
namespace {

constexpr std::string_view kFormat = "tripoint-calibration/1";
constexpr Permitted<std::int64_t> kSizePx{16, 8192};
constexpr Permitted<double> kFocalPx{1.0, 100'000.0};
constexpr Permitted<double> kCenterPx{-8192.0, 16'384.0};  // a cropped sensor may have its centre outside
constexpr Permitted<double> kDistortion{-1000.0, 1000.0};
constexpr Permitted<double> kRotationRad{-std::numbers::pi, std::numbers::pi};
constexpr Permitted<double> kTranslationMm{-10'000.0, 10'000.0};
constexpr Permitted<double> kLengthMm{0.001, 100'000.0};
constexpr double kUsefulUncertaintyShare = 0.01;

CameraModel camera_from(TableReader& table) {
  CameraModel camera;
  camera.size.width_px = static_cast<int>(table.integer("width_px", kSizePx));
  camera.size.height_px = static_cast<int>(table.integer("height_px", kSizePx));
  camera.focal_px = table.vec2("focal_px", kFocalPx);
  camera.center_px = table.vec2("center_px", kCenterPx);
  const std::vector<double> distortion = table.numbers("distortion", camera.distortion.size(), kDistortion);
  std::copy(distortion.begin(), distortion.end(), camera.distortion.begin());
  return camera;
}

void read_cameras(TableReader& root, Calibration& calibration) {
  TableReader cameras = root.table("cameras");
  for (const Side side : kBothSides) {
    TableReader table = cameras.table(name(side));
    calibration.stereo.cameras[side] = camera_from(table);
    calibration.serial[side] = table.text("serial", "");
    calibration.port[side] = table.text("port", "");
    table.finish();
  }
  cameras.finish();
}

Isometry3 pose_from(TableReader table) {
  const Vec3 rotation = table.vec3("rotation_rad", kRotationRad);
  Isometry3 pose = Isometry3::Identity();
  const double angle = rotation.norm();
  if (angle > 0.0) pose.linear() = Eigen::AngleAxisd{angle, rotation / angle}.toRotationMatrix();
  pose.translation() = table.vec3("translation_mm", kTranslationMm);
  table.finish();
  return pose;
}

std::optional<RigCovariance> covariance_from(TableReader& root) {
  if (!root.has("covariance")) return std::nullopt;
  constexpr std::size_t kEntries = std::size_t{24} * 24;
  constexpr Permitted<double> kEntry{-1e12, 1e12};
  TableReader table = root.table("covariance");
  const std::vector<double> entries = table.numbers("matrix", kEntries, kEntry);
  table.finish();
  const RigCovariance covariance = Eigen::Map<const Eigen::Matrix<double, 24, 24, Eigen::RowMajor>>(entries.data());
  const std::string fault = fault_of_covariance(covariance);
  if (!fault.empty()) table.refuse("matrix", fault);
  return 0.5 * (covariance + covariance.transpose());
}

std::vector<LengthCheck> lengths_from(TableReader& root) {
  std::vector<LengthCheck> lengths;
  TableReader quality = root.table("quality");
  quality.allow_other_keys();
  for (TableReader& table : quality.tables("lengths")) {
    lengths.push_back({table.number("nominal_mm", kLengthMm), table.number("measured_mm", kLengthMm),
                       table.number("uncertainty_mm", kLengthMm)});
    table.finish();
  }
  return lengths;
}

void check_rig(TableReader& root, const StereoCalibration& stereo) {
  const Result<Rig> rig = rig_of(stereo);
  if (!rig)
    root.refuse("right_from_left", fmt::format("{}; permitted is two lens centres apart, both looking the "
                                               "same way across the line between them",
                                               rig.error().message));
}

}  // namespace

bool verified_by_length(const Calibration& calibration) {
  return !calibration.lengths.empty() &&
         std::all_of(calibration.lengths.begin(), calibration.lengths.end(), [](const LengthCheck& length) {
           return length.uncertainty_mm <= kUsefulUncertaintyShare * length.nominal_mm &&
                  std::abs(length.measured_mm - length.nominal_mm) <= length.uncertainty_mm;
         });
}

Result<Calibration> parse_calibration(std::string_view text, std::string_view file_name) {
  const Result<TomlTable> tree = toml_tree_from(text, file_name);
  if (!tree) return tl::make_unexpected(tree.error());
  Findings findings{std::string{file_name}};
  TableReader root{findings, *tree};
  root.choice<bool>("format", {{kFormat, true}});

  Calibration calibration;
  calibration.created = root.time("created");
  root.truth("verified", false);  // for people: verified_by_length decides
  read_cameras(root, calibration);
  calibration.stereo.right_from_left = pose_from(root.table("right_from_left"));
  calibration.covariance = covariance_from(root);
  calibration.lengths = lengths_from(root);
  check_integrity(root, text);
  root.finish();
  if (!findings.error()) check_rig(root, calibration.stereo);
  if (findings.error()) return tl::make_unexpected(*findings.error());
  calibration.sha256 = sha256(text);
  calibration.id = id_from(calibration.sha256);
  return calibration;
}

Result<Calibration> load_calibration(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kMostDocumentBytes);
  if (!text) return tl::make_unexpected(text.error());
  return parse_calibration(*text, path.string());
}

}  // namespace tripoint
