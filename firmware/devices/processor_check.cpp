// Ends the program with a sentence on a processor that cannot run it, before any other code of it runs.
//
// All other files are compiled for x86-64-v2, and some of their objects are made before main begins: this file is
// compiled for every x86-64 (CMakeLists.txt), and comes before them.
#include <unistd.h>

#include <cstddef>
#include <string_view>

namespace {

constexpr int kFirst = 101;  // of the order of constructors; up to 100 is the implementation's
constexpr int kUsage = 2;    // as app/exit_code.h has it

#if defined(__x86_64__)
[[gnu::constructor(kFirst)]] void check_processor() {
  __builtin_cpu_init();
  // The instructions of x86-64-v2; whatever has these has the others of that level too.
  if (__builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("popcnt") != 0) return;
  constexpr std::string_view kMessage =
      "tripoint: this processor is older than x86-64-v2: it has no SSE4.2 or no POPCNT\n";
  (void)!write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(kUsage);
}
#endif

}  // namespace
