// Reads a TOML table key by key into checked values. The first thing wrong is kept, and reading goes on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document/toml_tree.h"
#include "values/linear.h"
#include "values/result.h"

namespace tripoint {

/// Both ends are permitted.
template <typename T>
struct Permitted {
  T min = std::numeric_limits<T>::lowest();
  T max = std::numeric_limits<T>::max();
};

/// What was read from one document and the first error in it, shared by its readers.
class Findings {
 public:
  explicit Findings(std::string file_name) : file_name_(std::move(file_name)) {}

  /// Keeps the first error, but a key that nobody knows explains one that is missing. `line` 0 stands for the
  /// command line.
  void refuse(ErrorCode code, int line, std::string_view what);
  /// Notes a value that was used, default or not.
  void note(std::string_view path, std::string value) { values_.emplace_back(path, std::move(value)); }

  /// Remembers where a key stands.
  void locate(std::string path, int line) { places_.emplace_back(std::move(path), place(line)); }

  /// "table.key" and "file:line" of each key that was there.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& places() const { return places_; }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// "table.key = value" for each value used, sorted: the same for every way of writing the same document.
  [[nodiscard]] std::vector<std::string> values() const;

 private:
  [[nodiscard]] std::string place(int line) const;

  std::string file_name_;
  std::optional<Error> error_;
  std::vector<std::pair<std::string, std::string>> values_;
  std::vector<std::pair<std::string, std::string>> places_;
};

/// One table. Every function names the key; without a default the key is required. After an error the default or a
/// zero comes back, and the whole document is refused in the end (Findings::error).
class TableReader {
 public:
  /// A table that is absent reads as an empty one.
  TableReader(Findings& findings, const TomlTable& document);

  [[nodiscard]] bool has(std::string_view key) const { return find(*table_, key) != nullptr; }

  double number(std::string_view key, Permitted<double> permitted, std::optional<double> otherwise = {});
  std::int64_t integer(std::string_view key, Permitted<std::int64_t> permitted,
                       std::optional<std::int64_t> otherwise = {});
  bool truth(std::string_view key, std::optional<bool> otherwise = {});
  std::string text(std::string_view key, std::optional<std::string_view> otherwise = {});
  std::vector<std::string> texts(std::string_view key);  ///< absent: none
  std::optional<UtcSecond> time(std::string_view key);   ///< absent: nothing

  /// A list of exactly `count` numbers; a list of lists counts as their numbers in a row.
  std::vector<double> numbers(std::string_view key, std::size_t count, Permitted<double> permitted);
  Vec2 vec2(std::string_view key, Permitted<double> permitted);
  Vec3 vec3(std::string_view key, Permitted<double> permitted);

  /// One of several words.
  template <typename E>
  E choice(std::string_view key, std::initializer_list<std::pair<std::string_view, E>> choices,
           std::optional<E> otherwise = {}) {
    std::vector<std::string_view> words;
    for (const auto& [word, value] : choices) words.push_back(word);
    std::optional<std::size_t> standard;
    for (std::size_t i = 0; otherwise && i < choices.size(); ++i) {
      if (choices.begin()[i].second == *otherwise) standard = i;
    }
    return choices.begin()[word(key, words, standard)].second;
  }

  TableReader table(std::string_view key);
  std::vector<TableReader> tables(std::string_view key);  ///< of [[key]]; absent: none

  /// Refuses a value for a reason that only the caller knows: "key = value: why"; "key: why" for one that is absent.
  void refuse(std::string_view key, std::string_view why);
  /// Leaves what else the table holds unread.
  void allow_other_keys() { others_allowed_ = true; }
  /// Refuses the keys nobody asked for, and names the nearest known one. To be called last.
  void finish();

 private:
  TableReader(Findings& findings, const TomlTable& table, int line, std::string path);

  const TomlNode* wanted(std::string_view key, bool required, std::string_view permitted = {});
  /// Index into `words`; 0 after an error.
  std::size_t word(std::string_view key, std::span<const std::string_view> words, std::optional<std::size_t> otherwise);
  [[nodiscard]] std::string path_of(std::string_view key) const;
  void refuse_value(std::string_view key, const TomlNode& node, std::string_view permitted);

  Findings* findings_;
  const TomlTable* table_;
  int line_;
  std::string path_;
  std::vector<std::string> known_;
  bool others_allowed_ = false;
};

}  // namespace tripoint
