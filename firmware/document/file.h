// Whole files: read with a bound, written whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "values/result.h"

namespace tripoint {

/// @return kCannotRead when the file is missing, not readable, no regular file or longer than `most_bytes`
Result<std::string> read_file(const std::filesystem::path& path, std::size_t most_bytes);

/// Replaces the file in one step: temporary file in the same folder, fsync, rename, fsync of the folder. Whatever
/// happens, the path holds the old content whole or the new content whole.
///
/// @return kCannotWrite with the path, the step and the system's reason; the temporary file is gone
Result<void> write_file_whole(const std::filesystem::path& path, std::string_view bytes);

}  // namespace tripoint
