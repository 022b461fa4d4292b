// Writing where nobody may be reading: a pipe that is full must not hold up a thread that measures or answers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tripoint {

class UnblockedOutput {
 public:
  /// @param descriptor  of the system, such as that of stderr; the output does not own it
  explicit UnblockedOutput(int descriptor) : descriptor_(descriptor) {}

  /// Writes a line, of which at most kLongest bytes, or drops it when that would have to wait. The next line that goes
  /// through says how many were dropped before it.
  void write(std::string_view line);

  /// POSIX: a pipe that can be written to takes so many bytes at once (PIPE_BUF).
  static constexpr std::size_t kLongest = 4096;

 private:
  [[nodiscard]] bool ready() const;

  int descriptor_;
  std::uint64_t dropped_ = 0;
};

}  // namespace tripoint
