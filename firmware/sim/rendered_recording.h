// Writes what the simulated cameras see as a recording folder, with its truth.
#pragma once

#include <filesystem>

#include "sim/world.h"
#include "values/result.h"

namespace tripoint {

/// Renders `frames` frames of each camera, from the world's start on, into `folder`, which must be empty or absent:
/// recording.toml, left/ and right/ (yuyv or jpg), frames.csv and truth.csv, all as the recording format says.
///
/// @return kOutOfRange   the world's format is GREY, for which recordings have no name
///         kCannotWrite  the folder is in use, or the disk is full
Result<void> write_rendered_recording(const SimulatedWorld& world, int frames, const std::filesystem::path& folder);

}  // namespace tripoint
