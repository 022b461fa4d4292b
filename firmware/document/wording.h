// Values and keys as words of a message.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/toml_tree.h"

namespace tripoint {

/// The number of a whole or broken value; nothing for any other.
std::optional<double> number_in(const TomlNode& node);

/// What follows a key: " = " and its value as it would be written, cut where it gets long; for tables and times what
/// they are.
std::string shown(const TomlNode& node);

/// "a", "b" or "c"
std::string alternatives(std::span<const std::string_view> words);

/// What follows an unknown key: the known key that is nearest by letters, or all of them; "" when none is known.
std::string nearest_of(std::string_view key, const std::vector<std::string>& known);

}  // namespace tripoint
