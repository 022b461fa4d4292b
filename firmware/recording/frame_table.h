// frames.csv: every frame of a recording in the order in which the line took them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "values/result.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

enum class RowKind : std::uint8_t { kFrame, kCameraLost, kCameraBack };

struct RecordedRow {
  RowKind kind = RowKind::kFrame;
  Side side = Side::kLeft;
  std::uint32_t index = 0;  ///< the driver's sequence number; 0 in a row that is no frame
  TimePoint exposed{};      ///< middle of the exposure of row 0; equal to `arrived` in a row that is no frame
  TimePoint arrived{};
  std::uint64_t forecast = 0;  ///< number of the forecast that the detector used, 0 = none
  std::size_t line = 0;        ///< of the file, from 1
};

/// Columns: camera,index,exposure_mid_ns,arrival_ns and after them, where present, forecast and event, each of which
/// may be empty. A row whose event is "lost" or "back" is no frame: index and exposure_mid_ns are empty.
/// Per camera the index rises and the arrival never falls; stamps of exposure may jitter past each other.
///
/// @return kMalformed with file and line
Result<std::vector<RecordedRow>> recorded_rows_from(std::string_view csv, std::string_view file_name);

}  // namespace tripoint
