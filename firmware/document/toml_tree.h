// A TOML text as a tree of values that remember their line.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "values/result.h"

namespace tripoint {

struct TomlNode;
struct TomlEntry;
using TomlArray = std::vector<TomlNode>;
using TomlTable = std::vector<TomlEntry>;  ///< in order of appearance; keys are unique
using UtcSecond = std::chrono::sys_seconds;

struct TomlNode {
  std::variant<bool, std::int64_t, double, std::string, UtcSecond, TomlArray, TomlTable> value;
  int line = 0;               ///< 0: given on the command line
  std::string as_given = {};  ///< the command line's text of the value
};

struct TomlEntry {
  std::string key;
  TomlNode node;
};

inline constexpr std::size_t kMostDocumentBytes = 1'000'000;

/// A date and time without an offset is taken as UTC; dates and times alone are refused.
///
/// @return kMalformed with file and line for text that is not TOML 1.0 or longer than kMostDocumentBytes
Result<TomlTable> toml_tree_from(std::string_view text, std::string_view file_name);

/// Nothing when the key is absent.
const TomlNode* find(const TomlTable& table, std::string_view key);

/// The table with one value put in or replaced: "table.key=value", the value as TOML, or else as plain text.
///
/// @return kMalformed when there is no "=", a part of the key is empty or names a value that is no table
Result<TomlTable> with_override(TomlTable table, std::string_view assignment);

}  // namespace tripoint
