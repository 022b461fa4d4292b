#include "line/pose/output_frame.h"

namespace tripoint {

void give_poses_in(OutputFrame frame, LineModel& model) {
  const bool by_camera = frame == OutputFrame::kLeftCamera;
  model.output_from_rig = by_camera ? model.rig.camera_from_rig.left : Isometry3::Identity();
  model.output_by_calibration.setZero();
  if (by_camera) model.output_by_calibration = left_from_rig_by_calibration(model.calibration);
}

Eigen::Matrix<double, 3, 24> place_in_output_by(const Eigen::Matrix<double, 3, 24>& in_rig, const Vec3& place_in_rig_mm,
                                                const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  return rotation * in_rig + model.output_by_calibration.topRows<3>() -
         cross_matrix(rotation * place_in_rig_mm) * model.output_by_calibration.bottomRows<3>();
}

Eigen::Matrix<double, 6, 24> pose_in_output_by(const Eigen::Matrix<double, 6, 24>& in_rig,
                                               const Vec3& position_in_rig_mm, const LineModel& model) {
  Eigen::Matrix<double, 6, 24> by;
  by << place_in_output_by(in_rig.topRows<3>(), position_in_rig_mm, model),
      model.output_from_rig.linear() * in_rig.bottomRows<3>() + model.output_by_calibration.bottomRows<3>();
  return by;
}

}  // namespace tripoint
