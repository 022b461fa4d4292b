// The checksum at the end of a calibration file: detects damage, not a forger.
#pragma once

#include <string_view>

#include "document/table_reader.h"

namespace tripoint {

/// Where [integrity] is present: sha256 = hash of all bytes before the line "[integrity]", the last table.
/// Anything else is refused in the reader's findings.
void check_integrity(TableReader& root, std::string_view text);

}  // namespace tripoint
