// What two open cameras show of a calibration board.
#pragma once

#include "app/board_search.h"
#include "app/camera_pair.h"

namespace tripoint {

/// The medians over some pictures.
///
/// @return errors of CameraPair::watch
Result<BoardLook> look_at_board(const CameraPair& cameras);

}  // namespace tripoint
