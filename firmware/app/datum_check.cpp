#include "app/datum_check.h"

#include <fmt/format.h>

#include <string>

#include "geometry/camera_model.h"

namespace tripoint {
namespace {

constexpr double kEdge_px = 10.0;  // a spot and the ground around it

tl::unexpected<Error> refused(const Config& config, const std::string& why) {
  return tl::make_unexpected(named_by(config, "datum.position_mm", {ErrorCode::kOutOfRange, why}));
}

double outside_volume_mm(const VolumeConfig& volume, const Vec3& in_output_mm) {
  return (in_output_mm - in_output_mm.cwiseMax(volume.min_mm).cwiseMin(volume.max_mm)).norm();
}

bool in_picture(const RawPixel& at, const ImageSize& size) {
  return at.u_px >= kEdge_px && at.v_px >= kEdge_px && at.u_px <= size.width_px - 1 - kEdge_px &&
         at.v_px <= size.height_px - 1 - kEdge_px;
}

}  // namespace

Result<void> check_datum(const Config& config, const LineModel* model) {
  if (!config.datum) return {};
  const Vec3& in_rig_mm = config.datum->position_mm;
  if (model != nullptr || config.output.frame == ConfiguredFrame::kReference) {
    const Vec3 in_output_mm = model != nullptr ? Vec3(model->output_from_rig * in_rig_mm) : in_rig_mm;
    const double outside_mm = outside_volume_mm(config.volume, in_output_mm);
    if (outside_mm < config.datum->radius_mm) {
      return refused(config,
                     fmt::format("{:.1f} mm outside [volume], less than datum.radius_mm = {}: the target could be "
                                 "taken for it; move the datum, or make volume or radius smaller",
                                 outside_mm, config.datum->radius_mm));
    }
  }
  if (model == nullptr) return {};
  for (const Side side : kBothSides) {
    const CameraModel& camera = model->rig.cameras[side];
    const Result<RawPixel> at = projected(camera, model->rig.camera_from_rig[side] * in_rig_mm);
    if (!at) {
      return refused(config,
                     fmt::format("not in front of the {} camera: the position is in the reference frame, whose z "
                                 "points away from the cameras",
                                 name(side)));
    }
    if (!in_picture(*at, camera.size)) {
      return refused(
          config, fmt::format("seen by the {} camera at {:.0f}, {:.0f} px: permitted is {:.0f} px or more "
                              "inside its picture of {} x {} px; move the datum",
                              name(side), at->u_px, at->v_px, kEdge_px, camera.size.width_px, camera.size.height_px));
    }
  }
  return {};
}

}  // namespace tripoint
