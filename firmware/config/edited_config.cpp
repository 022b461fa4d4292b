#include "config/edited_config.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "config/config.h"
#include "document/file.h"
#include "document/table_reader.h"

namespace tripoint {
namespace {

using Lines = std::vector<std::string>;

Lines lines_from(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    lines.emplace_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

/// The line of a key that the file gives, counted from 1; 0 when it gives none.
std::size_t line_of(const Config& config, const ConfigEdit& edit) {
  const std::string name = edit.table + "." + edit.key;
  for (const auto& [key, place] : config.places) {
    if (key == name) return std::stoul(place.substr(place.rfind(':') + 1));
  }
  return 0;
}

bool holds(const Config& config, const ConfigEdit& edit) {
  const std::string line = fmt::format("{}.{} = {}", edit.table, edit.key, edit.value);
  return std::find(config.values.begin(), config.values.end(), line) != config.values.end();
}

tl::unexpected<Error> not_editable(std::string_view file_name, const ConfigEdit& edit) {
  return failure(ErrorCode::kMalformed, fmt::format("{}: {}.{} cannot be changed without changing more: write {} = {} "
                                                    "there yourself",
                                                    file_name, edit.table, edit.key, edit.key, edit.value));
}

/// `a.b` as TOML permits to write it, with blanks around the dots.
std::string pattern_of(const std::string& table) {
  return std::regex_replace(table, std::regex(R"(\.)"), R"(\s*\.\s*)");
}

/// The key stands under its own table's heading, or under another's with the names of the tables between.
bool change(std::string& line, const ConfigEdit& edit) {
  const std::regex assignment(fmt::format(R"(^(\s*(?:[a-z_]+\s*\.\s*)*{}\s*=\s*)[0-9+_]+)", edit.key));
  std::smatch found;
  if (!std::regex_search(line, found, assignment)) return false;
  line = found.str(1) + std::to_string(edit.value) + found.suffix().str();
  return true;
}

void end(std::string& line) {
  if (line.back() != '\n') line += '\n';
}

void add(Lines& lines, const ConfigEdit& edit) {
  const std::regex heading(fmt::format(R"(^\s*\[\s*{}\s*\]\s*(#.*)?\r?\n?$)", pattern_of(edit.table)));
  auto found = std::find_if(lines.begin(), lines.end(),
                            [&](const std::string& line) { return std::regex_match(line, heading); });
  if (found == lines.end()) {
    end(lines.back());  // there is one: a configuration without any text is not valid
    lines.emplace_back("\n");
    found = lines.insert(lines.end(), fmt::format("[{}]", edit.table));
  }
  end(*found);
  lines.insert(found + 1, fmt::format("{} = {}\n", edit.key, edit.value));
}

/// Puts the value where it belongs, as far as lines tell.
std::optional<std::string> with_value(const std::string& text, std::size_t line, const ConfigEdit& edit) {
  Lines lines = lines_from(text);
  if (line == 0) {
    add(lines, edit);
  } else if (line > lines.size() || !change(lines[line - 1], edit)) {
    return std::nullopt;
  }
  return joined(lines);
}

/// What the configuration says with these values, whatever the text looks like.
Result<Config> wanted_from(std::string_view text, std::string_view file_name, std::span<const ConfigEdit> edits) {
  std::vector<std::string> overrides;
  for (const ConfigEdit& edit : edits) {
    overrides.push_back(fmt::format("{}.{}={}", edit.table, edit.key, edit.value));
  }
  return parse_config(text, file_name, overrides);
}

}  // namespace

Result<std::string> edited_config(std::string_view text, std::string_view file_name,
                                  std::span<const ConfigEdit> edits) {
  const Result<Config> wanted = wanted_from(text, file_name, edits);
  if (!wanted) return tl::make_unexpected(wanted.error());
  std::string edited(text);
  for (const ConfigEdit& edit : edits) {
    const Result<Config> before = parse_config(edited, file_name, {});
    if (!before) return not_editable(file_name, edits.front());  // by an edit: the text itself was read above
    if (holds(*before, edit)) continue;
    std::optional<std::string> next = with_value(edited, line_of(*before, edit), edit);
    if (!next) return not_editable(file_name, edit);
    edited = *std::move(next);
  }
  const Result<Config> read_again = parse_config(edited, file_name, {});
  if (!read_again || read_again->values != wanted->values) return not_editable(file_name, edits.front());
  return edited;
}

Result<std::filesystem::path> editable_file(const std::filesystem::path& path) {
  using std::filesystem::perms;
  std::error_code error;
  const std::filesystem::path file = std::filesystem::canonical(path, error);
  const perms permissions = error ? perms::none : std::filesystem::status(file, error).permissions();
  if (error) return failure(ErrorCode::kCannotRead, fmt::format("{}: {}", path.string(), error.message()));
  if ((permissions & (perms::owner_write | perms::group_write | perms::others_write)) != perms::none) return file;
  return failure(ErrorCode::kCannotWrite,
                 fmt::format("{}: is marked as read-only: permit writing, or have the lines printed", path.string()));
}

Result<void> edit_config_file(const std::filesystem::path& path, std::span<const ConfigEdit> edits) {
  const Result<std::filesystem::path> file = editable_file(path);
  if (!file) return tl::make_unexpected(file.error());
  std::error_code error;
  const std::filesystem::perms permissions = std::filesystem::status(*file, error).permissions();
  const Result<std::string> edited = read_file(*file, kMostDocumentBytes).and_then([&](const std::string& text) {
    return edited_config(text, path.string(), edits);
  });
  if (!edited) return tl::make_unexpected(edited.error());
  if (Result<void> written = write_file_whole(*file, *edited); !written) return written;
  std::filesystem::permissions(*file, permissions, error);
  if (!error) return {};
  return failure(ErrorCode::kCannotWrite, fmt::format("{}: {}", path.string(), error.message()));
}

std::string lines_of(std::span<const ConfigEdit> edits) {
  std::string text;
  std::string_view table;
  for (const ConfigEdit& edit : edits) {
    if (edit.table != table) text += fmt::format("[{}]\n", edit.table);
    table = edit.table;
    text += fmt::format("{} = {}\n", edit.key, edit.value);
  }
  return text;
}

}  // namespace tripoint
