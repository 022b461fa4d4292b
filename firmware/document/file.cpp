#include "document/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace tripoint {
namespace {

/// An open file, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool open() const { return fd_ >= 0; }

 private:
  int fd_;
};

tl::unexpected<Error> refused(ErrorCode code, const std::filesystem::path& path, std::string_view step) {
  return failure(code, fmt::format("{}: {}: {}", path.string(), step, std::generic_category().message(errno)));
}

bool written(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Syncs the folder's list of names, without which a rename may be lost with the power.
bool folder_synced(const std::filesystem::path& folder) {
  const Descriptor descriptor{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  return descriptor.open() && ::fsync(descriptor.get()) == 0;
}

Result<void> write_and_rename(const std::string& temporary, int fd, const std::filesystem::path& path,
                              std::string_view bytes) {
  constexpr mode_t kReadableByAll = 0644;  // mkstemp makes files that only their owner reads
  if (!written(fd, bytes)) return refused(ErrorCode::kCannotWrite, path, "cannot write");
  if (::fchmod(fd, kReadableByAll) != 0) return refused(ErrorCode::kCannotWrite, path, "cannot set permissions");
  if (::fsync(fd) != 0) return refused(ErrorCode::kCannotWrite, path, "cannot sync");
  if (::rename(temporary.c_str(), path.c_str()) != 0) return refused(ErrorCode::kCannotWrite, path, "cannot rename");
  return {};
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t most_bytes) {
  const Descriptor descriptor{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (!descriptor.open()) return refused(ErrorCode::kCannotRead, path, "cannot open");
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    return failure(ErrorCode::kCannotRead, fmt::format("{}: not a file", path.string()));
  }
  std::string bytes;
  std::array<char, 16384> part{};
  while (bytes.size() <= most_bytes) {
    const ssize_t count = ::read(descriptor.get(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refused(ErrorCode::kCannotRead, path, "cannot read");
    if (count == 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
  return failure(ErrorCode::kCannotRead, fmt::format("{}: longer than {} bytes", path.string(), most_bytes));
}

Result<void> write_file_whole(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::string temporary = path.string() + ".XXXXXX";
  const Descriptor descriptor{::mkstemp(temporary.data())};
  if (!descriptor.open()) return refused(ErrorCode::kCannotWrite, path, "cannot create a file beside it");
  Result<void> result = write_and_rename(temporary, descriptor.get(), path, bytes);
  if (!result) {
    ::unlink(temporary.c_str());
    return result;
  }
  if (!folder_synced(folder)) return refused(ErrorCode::kCannotWrite, path, "cannot sync the folder");
  return {};
}

}  // namespace tripoint
