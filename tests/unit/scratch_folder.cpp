#include "scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace tripoint::test {

ScratchFolder::ScratchFolder() {
  std::string made = (std::filesystem::temp_directory_path() / "tripoint-test-XXXXXX").string();
  if (::mkdtemp(made.data()) == nullptr) throw std::system_error(errno, std::generic_category(), made);
  path_ = made;
}

ScratchFolder::~ScratchFolder() {
  std::error_code left_behind;  // a destructor has nobody to tell
  std::filesystem::remove_all(path_, left_behind);
}

}  // namespace tripoint::test
