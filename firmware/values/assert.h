// TRIPOINT_ASSERT: a bug ends the program, also in a release build; the supervisor restarts it with outputs safe.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace tripoint {

[[noreturn]] inline void assertion_failed(const char* condition, const char* file, int line) {
  static_cast<void>(std::fprintf(stderr, "tripoint: bug: %s is false at %s:%d\n", condition, file, line));
  std::abort();
}

}  // namespace tripoint

#define TRIPOINT_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::tripoint::assertion_failed(#condition, __FILE__, __LINE__))
