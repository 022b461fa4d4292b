// `tripointd cameras`: what the configuration can bind to.
#pragma once

namespace tripoint {

/// Prints the cameras of this machine by USB port path and serial, as a table or one JSON list.
///
/// @return 0, or 3 when there is none
int cameras_command(bool json);

}  // namespace tripoint
