// Where `tripointd detect --explain FOLDER` puts its images, and under which names.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "values/result.h"

namespace tripoint {

class ExplanationFolder {
 public:
  /// Makes the folder when it is absent.
  ///
  /// @param inputs  pictures that are read: none of them is ever written over
  /// @return kCannotWrite when it cannot be made, or is no folder
  static Result<ExplanationFolder> open(const std::filesystem::path& folder,
                                        std::span<const std::filesystem::path> inputs);

  /// The same, or nothing for an empty path.
  static Result<std::optional<ExplanationFolder>> open_if_named(const std::filesystem::path& folder,
                                                                std::span<const std::filesystem::path> inputs);

  /// Writes FOLDER/NAME.explain.png, NAME being the input's without its ending; NAME-2, NAME-3 and so on when that name
  /// was given before or is an input's. An image of an earlier run is replaced.
  ///
  /// @param png  the whole file
  /// @return where it was written; kCannotWrite
  Result<std::filesystem::path> write(const std::filesystem::path& input, std::string_view png);

 private:
  ExplanationFolder(std::filesystem::path folder, std::span<const std::filesystem::path> inputs);
  [[nodiscard]] bool is_input(const std::filesystem::path& path) const;
  std::filesystem::path free_path(const std::filesystem::path& input);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> inputs_;
  std::set<std::filesystem::path> given_;
};

}  // namespace tripoint
