// A configuration's text with some values changed, and everything else as it was written.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "values/result.h"

namespace tripoint {

/// One whole number to be written.
struct ConfigEdit {
  std::string table;  ///< "cameras", "cameras.calibrating"
  std::string key;
  long value = 0;
};

/// Changes the lines of these keys; a key that is not there is added below its table's heading, unless the value is the
/// default; a table that is not there is added at the end. Comments, order and all other lines stay. What comes out is
/// read again: only these values may differ.
///
/// @return kMalformed, saying what to do by hand, for a table that is written in braces; errors of parse_config
Result<std::string> edited_config(std::string_view text, std::string_view file_name, std::span<const ConfigEdit> edits);

/// The file behind a path and its links.
///
/// @return kCannotRead when it is missing; kCannotWrite when it is marked as read-only
Result<std::filesystem::path> editable_file(const std::filesystem::path& path);

/// As edited_config for a file, which is replaced in one step and keeps its permissions; a link stays a link.
///
/// @return as edited_config and editable_file; kCannotWrite
Result<void> edit_config_file(const std::filesystem::path& path, std::span<const ConfigEdit> edits);

/// The lines for someone to write: "[cameras]", "exposure_us = 1200".
std::string lines_of(std::span<const ConfigEdit> edits);

}  // namespace tripoint
