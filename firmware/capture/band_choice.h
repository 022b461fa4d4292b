// Which rows of a camera's next picture have to be decoded: those around the forecast, or all of them.
#pragma once

#include <cstdint>
#include <optional>

#include "line/observation.h"
#include "ports/frame.h"
#include "values/forecast.h"
#include "values/pixel.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// What one camera's pictures showed, as far as it matters to the next one. As made: nothing yet.
struct Sightings {
  std::optional<std::uint32_t> whole_frame;  ///< number of the last picture that was seen whole
  std::size_t spots_of_whole = 0;
  std::size_t spots = 0;  ///< in the last picture
  bool cut = false;       ///< not all of it was looked at
  bool foreseen = false;  ///< each of them was where the forecast had said before
  int reach_px = 0;       ///< rows around a spot that had a say, lately the most
};

/// @param seen     with side, number, time and coverage
/// @param forecast known before that picture
Sightings with(const Sightings& before, const Observation& seen, const Forecast& forecast);

/// A picture before it is decoded.
struct NextPicture {
  Side side = Side::kLeft;
  std::uint32_t frame = 0;  ///< the driver's number
  TimePoint exposed{};
  ImageSize size;
};

/// One band for each point of the forecast: 4 standard deviations of its place and what had a say around the last
/// spots. All of the picture instead (no bands) when
///   - the last whole picture is kFramesPerWhole frames back, or there is none since the camera came;
///   - that picture showed more or fewer spots than the target has points;
///   - the last picture missed a spot, showed one more, or one that was not foreseen (a new motion is not known yet),
///     or was not looked at to the end;
///   - there is no forecast, or it is meant for another time, or a place is too uncertain or outside the picture;
///   - the bands would cover more than half of it.
RowBands chosen_bands(const Sightings& sightings, const Forecast& forecast, const NextPicture& next);

}  // namespace tripoint
