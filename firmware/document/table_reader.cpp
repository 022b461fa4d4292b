#include "document/table_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "document/wording.h"

namespace tripoint {
namespace {

constexpr std::size_t kMostTextBytes = 4096;  // the longest path Linux takes
const TomlTable kNoTable{};
const TomlArray kNoArray{};

/// The command line needs no quotes: there any value is a text where a text is wanted.
std::optional<std::string> text_in(const TomlNode& node) {
  const auto* text = std::get_if<std::string>(&node.value);
  if (text == nullptr && node.as_given.empty()) return std::nullopt;
  std::string found = text != nullptr ? *text : node.as_given;
  const bool printable = std::none_of(found.begin(), found.end(), [](char c) { return c == '\0' || c == '\n'; });
  if (found.size() > kMostTextBytes || !printable) return std::nullopt;
  return found;
}

/// "a number from 0 to 1"; without the range when all are permitted.
template <typename T>
std::string range(std::string_view kind, const Permitted<T>& permitted) {
  const Permitted<T> all;
  if (permitted.min == all.min && permitted.max == all.max) return std::string{kind};
  return fmt::format("{} from {} to {}", kind, permitted.min, permitted.max);
}

bool append_numbers(const TomlArray& array, std::vector<double>& numbers, bool nested) {
  return std::all_of(array.begin(), array.end(), [&](const TomlNode& node) {
    if (const auto number = number_in(node)) {
      numbers.push_back(*number);
      return true;
    }
    const auto* inner = std::get_if<TomlArray>(&node.value);
    return inner != nullptr && !nested && append_numbers(*inner, numbers, true);
  });
}

}  // namespace

void Findings::refuse(ErrorCode code, int line, std::string_view what) {
  const bool misspelt = code == ErrorCode::kUnknownKey && error_ && error_->code == ErrorCode::kMissingKey;
  if (error_ && !misspelt) return;
  error_ = Error{code, fmt::format("{}: {}", place(line), what)};
}

std::string Findings::place(int line) const {
  return line > 0 ? fmt::format("{}:{}", file_name_, line) : fmt::format("{} with --set", file_name_);
}

std::vector<std::string> Findings::values() const {
  std::vector<std::string> lines;
  for (const auto& [path, value] : values_) lines.push_back(fmt::format("{} = {}", path, value));
  std::sort(lines.begin(), lines.end());
  return lines;
}

TableReader::TableReader(Findings& findings, const TomlTable& document) : TableReader(findings, document, 1, "") {}

TableReader::TableReader(Findings& findings, const TomlTable& table, int line, std::string path)
    : findings_(&findings), table_(&table), line_(line), path_(std::move(path)) {}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string{key} : fmt::format("{}.{}", path_, key);
}

const TomlNode* TableReader::wanted(std::string_view key, bool required, std::string_view permitted) {
  known_.emplace_back(key);
  const TomlNode* node = find(*table_, key);
  if (node == nullptr && required) {
    findings_->refuse(ErrorCode::kMissingKey, std::max(line_, 1),
                      fmt::format("{} is missing: permitted is {}", path_of(key), permitted));
  }
  if (node != nullptr) findings_->locate(path_of(key), node->line);
  return node;
}

void TableReader::refuse_value(std::string_view key, const TomlNode& node, std::string_view permitted) {
  findings_->refuse(ErrorCode::kOutOfRange, node.line,
                    fmt::format("{}{}: permitted is {}", path_of(key), shown(node), permitted));
}

void TableReader::refuse(std::string_view key, std::string_view why) {
  const TomlNode* node = find(*table_, key);
  const int line = node != nullptr ? node->line : std::max(line_, 1);
  const bool plain = node != nullptr && shown(*node).starts_with(" = ");  // of a table its name says enough
  findings_->refuse(node != nullptr ? ErrorCode::kOutOfRange : ErrorCode::kMissingKey, line,
                    fmt::format("{}{}: {}", path_of(key), plain ? shown(*node) : "", why));
}

double TableReader::number(std::string_view key, Permitted<double> permitted, std::optional<double> otherwise) {
  const std::string good = range("a number", permitted);
  const TomlNode* node = wanted(key, !otherwise, good);
  double value = otherwise.value_or(0.0);
  if (node != nullptr) {
    const std::optional<double> found = number_in(*node);
    if (found && *found >= permitted.min && *found <= permitted.max) {
      value = *found;
    } else {
      refuse_value(key, *node, good);
    }
  }
  findings_->note(path_of(key), fmt::format("{}", value));
  return value;
}

std::int64_t TableReader::integer(std::string_view key, Permitted<std::int64_t> permitted,
                                  std::optional<std::int64_t> otherwise) {
  const std::string good = range("a whole number", permitted);
  const TomlNode* node = wanted(key, !otherwise, good);
  std::int64_t value = otherwise.value_or(0);
  if (node != nullptr) {
    const auto* found = std::get_if<std::int64_t>(&node->value);
    if (found != nullptr && *found >= permitted.min && *found <= permitted.max) {
      value = *found;
    } else {
      refuse_value(key, *node, good);
    }
  }
  findings_->note(path_of(key), fmt::format("{}", value));
  return value;
}

bool TableReader::truth(std::string_view key, std::optional<bool> otherwise) {
  constexpr std::string_view kPermitted = "true or false";
  const TomlNode* node = wanted(key, !otherwise, kPermitted);
  bool value = otherwise.value_or(false);
  if (node != nullptr) {
    const auto* found = std::get_if<bool>(&node->value);
    if (found == nullptr) refuse_value(key, *node, kPermitted);
    value = found != nullptr && *found;
  }
  findings_->note(path_of(key), value ? "true" : "false");
  return value;
}

std::string TableReader::text(std::string_view key, std::optional<std::string_view> otherwise) {
  constexpr std::string_view kPermitted = "one line of text in quotes";
  const TomlNode* node = wanted(key, !otherwise, kPermitted);
  std::string value{otherwise.value_or("")};
  if (node != nullptr) {
    std::optional<std::string> found = text_in(*node);
    if (!found) refuse_value(key, *node, kPermitted);
    value = std::move(found).value_or("");
  }
  findings_->note(path_of(key), value);
  return value;
}

std::vector<std::string> TableReader::texts(std::string_view key) {
  std::vector<std::string> values;
  if (const TomlNode* node = wanted(key, false)) {
    const auto* array = std::get_if<TomlArray>(&node->value);
    for (const TomlNode& item : array != nullptr ? *array : kNoArray) {
      if (std::optional<std::string> text = text_in(item)) values.push_back(*std::move(text));
    }
    if (array == nullptr || values.size() != array->size())
      refuse_value(key, *node, R"(a list of texts in quotes, as ["a", "b"])");
  }
  findings_->note(path_of(key), fmt::format("[{}]", fmt::join(values, ", ")));
  return values;
}

std::optional<UtcSecond> TableReader::time(std::string_view key) {
  const TomlNode* node = wanted(key, false);
  if (node == nullptr) return std::nullopt;
  const auto* found = std::get_if<UtcSecond>(&node->value);
  if (found == nullptr) {
    refuse_value(key, *node, "a date and time without quotes, as 2026-01-31T12:00:00Z");
    return std::nullopt;
  }
  return *found;
}

std::vector<double> TableReader::numbers(std::string_view key, std::size_t count, Permitted<double> permitted) {
  std::vector<double> values;
  const std::string wanted_numbers = range(fmt::format("{} numbers", count), permitted);
  if (const TomlNode* node = wanted(key, true, wanted_numbers)) {
    const auto* array = std::get_if<TomlArray>(&node->value);
    const bool good =
        array != nullptr && append_numbers(*array, values, false) && values.size() == count &&
        std::all_of(values.begin(), values.end(), [&](double v) { return v >= permitted.min && v <= permitted.max; });
    if (!good) {
      refuse_value(key, *node, wanted_numbers);
      values.clear();
    }
  }
  values.resize(count, 0.0);
  findings_->note(path_of(key), fmt::format("[{}]", fmt::join(values, ", ")));
  return values;
}

Vec2 TableReader::vec2(std::string_view key, Permitted<double> permitted) {
  const std::vector<double> values = numbers(key, 2, permitted);
  return {values[0], values[1]};
}

Vec3 TableReader::vec3(std::string_view key, Permitted<double> permitted) {
  const std::vector<double> values = numbers(key, 3, permitted);
  return {values[0], values[1], values[2]};
}

std::size_t TableReader::word(std::string_view key, std::span<const std::string_view> words,
                              std::optional<std::size_t> otherwise) {
  const TomlNode* node = wanted(key, !otherwise, alternatives(words));
  std::size_t index = otherwise.value_or(0);
  if (node != nullptr) {
    const std::optional<std::string> text = text_in(*node);
    const auto found = std::find(words.begin(), words.end(), text.value_or(""));
    if (found == words.end()) {
      refuse_value(key, *node, alternatives(words));
    } else {
      index = static_cast<std::size_t>(found - words.begin());
    }
  }
  findings_->note(path_of(key), std::string{words[index]});
  return index;
}

TableReader TableReader::table(std::string_view key) {
  const TomlNode* node = wanted(key, false);
  if (node == nullptr) return {*findings_, kNoTable, line_, path_of(key)};
  const auto* table = std::get_if<TomlTable>(&node->value);
  if (table == nullptr) refuse_value(key, *node, fmt::format("a table [{}]", path_of(key)));
  return {*findings_, table != nullptr ? *table : kNoTable, node->line, path_of(key)};
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  std::vector<TableReader> readers;
  const TomlNode* node = wanted(key, false);
  if (node == nullptr) return readers;
  const auto* array = std::get_if<TomlArray>(&node->value);
  for (const TomlNode& item : array != nullptr ? *array : kNoArray) {
    if (const auto* table = std::get_if<TomlTable>(&item.value)) {
      readers.push_back({*findings_, *table, item.line, fmt::format("{}[{}]", path_of(key), readers.size())});
    }
  }
  if (array == nullptr || readers.size() != array->size()) {
    refuse_value(key, *node, fmt::format("tables, each begun by [[{}]]", path_of(key)));
    readers.clear();
  }
  return readers;
}

void TableReader::finish() {
  if (others_allowed_) return;
  for (const TomlEntry& entry : *table_) {
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    findings_->refuse(ErrorCode::kUnknownKey, entry.node.line,
                      fmt::format("unknown key {}{}", path_of(entry.key), nearest_of(entry.key, known_)));
  }
}

}  // namespace tripoint
