#include "app/verdict_json.h"

#include <nlohmann/json.hpp>

namespace tripoint {
namespace {

using nlohmann::ordered_json;

std::string_view frame_name(OutputFrame frame) {
  switch (frame) {
    case OutputFrame::kReference:
      return "reference";
    case OutputFrame::kLeftCamera:
      return "left_camera";
    case OutputFrame::kRobotBase:
      return "robot_base";
  }
  return "";
}

ordered_json names(Faults faults) {
  ordered_json list = ordered_json::array();
  for (std::size_t bit = 0; bit < kFaultNames.size(); ++bit) {
    if (faults.contains(static_cast<Fault>(bit))) list.push_back(kFaultNames[bit]);
  }
  return list;
}

ordered_json as_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

ordered_json as_json(const RawPixel& pixel) { return {pixel.u_px, pixel.v_px}; }

ordered_json corner_of(const Matrix6& matrix, int size) {
  ordered_json rows = ordered_json::array();
  for (int i = 0; i < size; ++i) {
    ordered_json row = ordered_json::array();
    for (int j = 0; j < size; ++j) row.push_back(matrix(i, j));
    rows.push_back(row);
  }
  return rows;
}

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json quaternion(const TargetPose& pose) {
  if (!pose.output_from_target) return nullptr;
  Eigen::Quaterniond q(*pose.output_from_target);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return {q.w(), q.x(), q.y(), q.z()};
}

ordered_json points(const Measurement& measurement) {
  ordered_json list = ordered_json::array();
  for (const MeasuredPoint& point : measurement.points) {
    list.push_back({{"id", point.id},
                    {"position_mm", as_json(point.in_output_mm)},
                    {"left_px", as_json(point.at.left)},
                    {"right_px", as_json(point.at.right)}});
  }
  return list;
}

}  // namespace

std::string verdict_json(const Measurement& measurement, OutputFrame frame) {
  const std::optional<TargetPose>& pose = measurement.pose;
  const bool oriented = pose && pose->output_from_target;
  const int size = oriented ? 6 : 3;
  const ordered_json line{
      {"t_ns", ns_from_time(measurement.exposed)},
      {"sequence", measurement.sequence},
      {"valid", pose.has_value()},
      {"orientation_valid", oriented},
      {"mount_watched", measurement.mount_watched},
      {"faults", names(measurement.faults)},
      {"side_length_error_mm", or_null(measurement.side_length_error_mm)},
      {"decalibration_mm", or_null(measurement.decalibration_mm)},
      {"position_mm", pose ? as_json(pose->position_in_output_mm) : ordered_json(nullptr)},
      {"quaternion_wxyz", pose ? quaternion(*pose) : ordered_json(nullptr)},
      {"covariance", pose ? corner_of(pose->noise + pose->shared, size) : ordered_json(nullptr)},
      {"covariance_shared", pose ? corner_of(pose->shared, size) : ordered_json(nullptr)},
      {"points", points(measurement)},
      {"frame", frame_name(frame)},
  };
  return line.dump();
}

}  // namespace tripoint
