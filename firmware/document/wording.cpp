#include "document/wording.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tripoint {
namespace {

constexpr std::size_t kShownBytes = 60;  // of a refused value in a message

bool holds_tables(const TomlArray& array) {
  return !array.empty() && std::holds_alternative<TomlTable>(array.front().value);
}

std::string written(const TomlNode& node);

std::string written(const TomlArray& array) {
  std::string text = "[";
  for (const TomlNode& item : array) {
    if (text.size() > kShownBytes) return text + ", ...]";
    text += (text.size() > 1 ? ", " : "") + written(item);
  }
  return text + "]";
}

/// A value as it would be written in the file, cut where it gets long.
std::string written(const TomlNode& node) {
  if (!node.as_given.empty()) return node.as_given.substr(0, kShownBytes);
  if (const auto* truth = std::get_if<bool>(&node.value)) return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&node.value))
    return fmt::format("\"{}{}\"", text->substr(0, kShownBytes), text->size() > kShownBytes ? "..." : "");
  if (const auto number = number_in(node)) return fmt::format("{}", *number);
  if (const auto* array = std::get_if<TomlArray>(&node.value)) return written(*array);
  return std::holds_alternative<TomlTable>(node.value) ? "{a table}" : "a date and time";
}

/// Levenshtein: how many letters to put in, take out or replace.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (letter == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<double> number_in(const TomlNode& node) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*integer);
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  return std::nullopt;
}

std::string shown(const TomlNode& node) {
  const auto* array = std::get_if<TomlArray>(&node.value);
  if (std::holds_alternative<TomlTable>(node.value)) return " is a table";
  if (array != nullptr && holds_tables(*array)) return " is a list of tables";
  if (std::holds_alternative<UtcSecond>(node.value) && node.as_given.empty()) return " is a date and time";
  return " = " + written(node);
}

std::string alternatives(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view comma = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += fmt::format("{}\"{}\"", comma, words[i]);
  }
  return text;
}

std::string nearest_of(std::string_view key, const std::vector<std::string>& known) {
  if (known.empty() || key.size() > kShownBytes) return {};
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edits_between(key, a) < edits_between(key, b);
  });
  if (edits_between(key, *nearest) <= std::max<std::size_t>(2, key.size() / 3)) {
    return fmt::format(" (did you mean {}?)", *nearest);
  }
  return fmt::format("; permitted is {}", fmt::join(known, ", "));
}

}  // namespace tripoint
