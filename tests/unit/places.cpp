#include "places.h"

#include <cstdlib>

namespace tripoint::test {

std::filesystem::path top_folder() { return TRIPOINT_TOP; }

std::filesystem::path shared_folder() {
  const char* given = std::getenv("TRIPOINT_SHARED");
  return given != nullptr ? std::filesystem::path(given) : top_folder() / ".." / "shared";
}

}  // namespace tripoint::test
