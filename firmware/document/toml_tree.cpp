#include "document/toml_tree.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

// toml++ asserts what it expects of the text, and some texts, "[+" among them, are otherwise: those are refused by
// us like any other that is not TOML. In a release build it would take its assertions for granted instead.
namespace tripoint {
namespace {
struct UnexpectedText {};
constexpr void expect(bool condition) {
  if (!condition) throw UnexpectedText{};
}
}  // namespace
}  // namespace tripoint
#undef NDEBUG
#define TOML_ASSERT(condition) ::tripoint::expect(static_cast<bool>(condition))
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace tripoint {
namespace {

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// @return nothing for a date or a time alone
std::optional<TomlNode> node_from(const toml::node& node);

std::optional<TomlTable> table_from(const toml::table& source) {
  TomlTable table;
  for (const auto& [key, value] : source) {
    std::optional<TomlNode> node = node_from(value);
    if (!node) return std::nullopt;
    table.push_back({std::string{key.str()}, *std::move(node)});
  }
  std::stable_sort(table.begin(), table.end(),
                   [](const TomlEntry& a, const TomlEntry& b) { return a.node.line < b.node.line; });
  return table;
}

std::optional<TomlArray> array_from(const toml::array& source) {
  TomlArray array;
  for (const toml::node& value : source) {
    std::optional<TomlNode> node = node_from(value);
    if (!node) return std::nullopt;
    array.push_back(*std::move(node));
  }
  return array;
}

UtcSecond utc_from(const toml::date_time& time) {
  const std::chrono::year_month_day day{std::chrono::year{static_cast<int>(time.date.year)},
                                        std::chrono::month{static_cast<unsigned>(time.date.month)},
                                        std::chrono::day{static_cast<unsigned>(time.date.day)}};
  const std::chrono::minutes offset{time.offset ? time.offset->minutes : 0};
  return std::chrono::sys_days{day} + std::chrono::hours{time.time.hour} + std::chrono::minutes{time.time.minute} +
         std::chrono::seconds{time.time.second} - offset;
}

std::optional<TomlNode> node_from(const toml::node& node) {
  const int line = line_of(node);
  if (const auto* truth = node.as_boolean()) return TomlNode{truth->get(), line};
  if (const auto* integer = node.as_integer()) return TomlNode{integer->get(), line};
  if (const auto* number = node.as_floating_point()) return TomlNode{number->get(), line};
  if (const auto* text = node.as_string()) return TomlNode{text->get(), line};
  if (const auto* time = node.as_date_time()) return TomlNode{utc_from(time->get()), line};
  if (const auto* array = node.as_array()) {
    std::optional<TomlArray> values = array_from(*array);
    return values ? std::optional{TomlNode{*std::move(values), line}} : std::nullopt;
  }
  if (const auto* table = node.as_table()) {
    std::optional<TomlTable> values = table_from(*table);
    return values ? std::optional{TomlNode{*std::move(values), line}} : std::nullopt;
  }
  return std::nullopt;
}

/// "Error while parsing table header: expected ']'" says the same without its first words.
std::string_view reason_in(std::string_view description) {
  constexpr std::string_view kPreamble = "Error while parsing ";
  if (description.starts_with(kPreamble)) description.remove_prefix(kPreamble.size());
  return description;
}

/// Line of the first date or time alone; 0 when there is none.
int line_of_lone_time(const toml::node& node) {
  if (node.is_date() || node.is_time()) return line_of(node);
  int line = 0;
  const auto look = [&line](const toml::node& inner) {
    if (line == 0) line = line_of_lone_time(inner);
  };
  if (const auto* array = node.as_array()) std::for_each(array->begin(), array->end(), look);
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) look(value);
  }
  return line;
}

Result<TomlTable> checked_tree(const toml::parse_result& parsed, std::string_view file_name) {
  if (!parsed) {
    return failure(ErrorCode::kMalformed,
                   fmt::format("{}:{}: not TOML: {}", file_name, parsed.error().source().begin.line,
                               reason_in(parsed.error().description())));
  }
  std::optional<TomlTable> table = table_from(parsed.table());
  if (table) return *std::move(table);
  return failure(ErrorCode::kMalformed,
                 fmt::format("{}:{}: a date or time alone: permitted is both together, as 2026-01-31T12:00:00Z",
                             file_name, line_of_lone_time(parsed.table())));
}

/// The value of an override: TOML when it reads as such, else the text as it stands.
TomlNode value_from(std::string_view text) {
  const Result<TomlTable> parsed = toml_tree_from(fmt::format("value = {}", text), "");
  TomlNode node{std::string{text}};
  if (parsed && parsed->size() == 1) node = parsed->front().node;
  node.line = 0;
  node.as_given = text;
  return node;
}

TomlNode& child(TomlTable& table, std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const TomlEntry& e) { return e.key == key; });
  if (found != table.end()) return found->node;
  table.push_back({std::string{key}, TomlNode{TomlTable{}}});
  return table.back().node;
}

}  // namespace

Result<TomlTable> toml_tree_from(std::string_view text, std::string_view file_name) {
  if (text.size() > kMostDocumentBytes) {
    return failure(ErrorCode::kMalformed,
                   fmt::format("{}: {} bytes; permitted is up to {}", file_name, text.size(), kMostDocumentBytes));
  }
  try {
    return checked_tree(toml::parse(text), file_name);
  } catch (const UnexpectedText&) {
    return failure(ErrorCode::kMalformed, fmt::format("{}: not TOML", file_name));
  }
}

const TomlNode* find(const TomlTable& table, std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const TomlEntry& e) { return e.key == key; });
  return found == table.end() ? nullptr : &found->node;
}

Result<TomlTable> with_override(TomlTable table, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const auto refused = [&] {
    return failure(ErrorCode::kMalformed, fmt::format("--set {}: permitted is table.key=value", assignment));
  };
  if (equals == std::string_view::npos) return refused();
  std::string_view path = assignment.substr(0, equals);
  TomlTable* place = &table;
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    if (dot == 0) return refused();
    place = std::get_if<TomlTable>(&child(*place, path.substr(0, dot)).value);
    if (place == nullptr) return refused();
    path.remove_prefix(dot + 1);
  }
  if (path.empty()) return refused();
  child(*place, path) = value_from(assignment.substr(equals + 1));
  return table;
}

}  // namespace tripoint
