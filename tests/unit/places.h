// Where tests find files.
#pragma once

#include <filesystem>

namespace tripoint::test {

/// Top of the checkout.
std::filesystem::path top_folder();

/// Pictures and measurements of others: TRIPOINT_SHARED, else `shared` beside the checkout. May be absent.
std::filesystem::path shared_folder();

}  // namespace tripoint::test
