#include "app/exit_code.h"

#include <fmt/core.h>

namespace tripoint {

int report(const Error& error) {
  fmt::print(stderr, "tripointd: {}\n", error.message);
  const bool device = error.code == ErrorCode::kDeviceMissing || error.code == ErrorCode::kDeviceBusy;
  return number(device ? ExitCode::kDeviceMissing : ExitCode::kUsage);
}

}  // namespace tripoint
