// How well the place of a spot can be known at all from the luma of a rendered picture.
#pragma once

#include "sim/renderer.h"
#include "sim/scene.h"
#include "sim/sensor.h"

namespace tripoint::bench {

/// Cramer-Rao bound of the place of a light's core, per axis (RMS over u and v and over the places of the spot in the
/// mosaic), from luma alone: amplitude and background unknown too, noise correlated as demosaicing makes it, luma
/// rounded to whole steps. Clipping is left out: for lights that do not clip.
/// Source: Kay 1993, "Fundamentals of Statistical Signal Processing: Estimation Theory", eq. 3.31.
double luma_bound_px(const SensorModel& sensor, const LightTruth& spot, const LightSource& light,
                     const LinearColor& background);

/// What a scene's wall, without its texture, adds to each channel, in units of clip.
LinearColor wall_level(const Scene& scene);

/// A sensor whose gain is raised until the bound is `bound_px`: as in a short exposure of a weak light, shot noise and
/// read noise grow together, in units of clip.
SensorModel sensor_with_bound(double bound_px, const LightTruth& spot, const LightSource& light,
                              const LinearColor& background);

}  // namespace tripoint::bench
