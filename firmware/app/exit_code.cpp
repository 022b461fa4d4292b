#include "app/exit_code.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace tripoint {

int report(const Error& error) {
  fmt::print(stderr, "tripointd: {}\n", error.message);
  const bool device = error.code == ErrorCode::kDeviceMissing || error.code == ErrorCode::kDeviceBusy;
  return number(device ? ExitCode::kDeviceMissing : ExitCode::kUsage);
}

int code_with_output_written(int code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  const std::string reason = errno != 0 ? std::generic_category().message(errno) : "an earlier write failed";
  return report({ErrorCode::kCannotWrite,
                 fmt::format("the output cannot be written ({}): make room there, or send it elsewhere", reason)});
}

}  // namespace tripoint
