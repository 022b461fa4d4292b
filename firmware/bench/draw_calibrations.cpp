// Prints calibrations of the simulated rig as a board and a wand might have given them, one file after another: each in
// error, each stating by how much.
//
// usage: draw_calibrations COUNT
#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>

#include "bench/erring_units.h"
#include "sim/default_rig.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kSeed = 3;

void print(const char* key, std::span<const double> values) {
  std::printf("%s = [", key);
  for (const double& value : values) std::printf("%s%.17g", &value == values.data() ? "" : ", ", value);
  std::printf("]\n");
}

void print(const char* side, const CameraModel& camera) {
  std::printf("[cameras.%s]\nserial = \"\"\nport = \"\"\nwidth_px = %d\nheight_px = %d\n", side, camera.size.width_px,
              camera.size.height_px);
  print("focal_px", std::span(camera.focal_px.data(), 2));
  print("center_px", std::span(camera.center_px.data(), 2));
  print("distortion", camera.distortion);
}

void print(const StereoCalibration& calibration, const RigCovariance& covariance) {
  std::printf("format = \"tripoint-calibration/1\"\ncreated = 2026-11-25T12:00:00Z\nverified = false\n");
  print("left", calibration.cameras.left);
  print("right", calibration.cameras.right);
  const RigParameters parameters = parameters_of(calibration);
  std::printf("[right_from_left]\n");
  print("rotation_rad", std::span(parameters.data() + 18, 3));
  print("translation_mm", std::span(parameters.data() + 21, 3));
  std::printf("[covariance]\n");
  print("matrix", std::span(covariance.data(), 576));  // symmetric: by columns is by rows
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: draw_calibrations COUNT\n");
    return 2;
  }
  const tripoint::bench::ErringUnits units(tripoint::default_rig(), {});
  std::mt19937_64 random(tripoint::bench::kSeed);
  for (long left = std::strtol(words[1], nullptr, 10); left > 0; --left) {
    const tripoint::LineModel model = units.model({}, random);
    tripoint::bench::print(model.calibration, model.covariance);
  }
}
