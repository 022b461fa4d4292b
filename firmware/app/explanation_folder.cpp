#include "app/explanation_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "document/file.h"

namespace tripoint {

namespace fs = std::filesystem;

Result<ExplanationFolder> ExplanationFolder::open(const fs::path& folder, std::span<const fs::path> inputs) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    return failure(ErrorCode::kCannotWrite,
                   fmt::format("{}: cannot make this folder for explanations: {}", folder.string(), error.message()));
  }
  if (!fs::is_directory(folder, error)) {
    return failure(ErrorCode::kCannotWrite,
                   fmt::format("{}: not a folder: name one for the explanations", folder.string()));
  }
  return ExplanationFolder(folder, inputs);
}

Result<std::optional<ExplanationFolder>> ExplanationFolder::open_if_named(const fs::path& folder,
                                                                          std::span<const fs::path> inputs) {
  if (folder.empty()) return std::nullopt;
  return open(folder, inputs).map([](ExplanationFolder opened) { return std::optional(std::move(opened)); });
}

ExplanationFolder::ExplanationFolder(fs::path folder, std::span<const fs::path> inputs)
    : folder_(std::move(folder)), inputs_(inputs.begin(), inputs.end()) {}

Result<fs::path> ExplanationFolder::write(const fs::path& input, std::string_view png) {
  const fs::path path = free_path(input);
  return write_file_whole(path, png).map([&] { return path; });
}

bool ExplanationFolder::is_input(const fs::path& path) const {
  return std::any_of(inputs_.begin(), inputs_.end(), [&](const fs::path& input) {
    std::error_code error;  // a path that does not exist is no other one
    return fs::equivalent(path, input, error);
  });
}

fs::path ExplanationFolder::free_path(const fs::path& input) {
  const std::string name = input.stem().string();
  fs::path path = folder_ / fmt::format("{}.explain.png", name);
  for (int number = 2; given_.contains(path) || is_input(path); ++number) {
    path = folder_ / fmt::format("{}-{}.explain.png", name, number);
  }
  given_.insert(path);
  return path;
}

}  // namespace tripoint
