#include "document/sha256.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include "values/assert.h"

namespace tripoint {

Sha256 sha256(std::string_view bytes) {
  Sha256 hash{};
  const int done = EVP_Digest(bytes.data(), bytes.size(), hash.data(), nullptr, EVP_sha256(), nullptr);
  TRIPOINT_ASSERT(done == 1);
  return hash;
}

std::string hex_from(const Sha256& hash) { return fmt::format("{:02x}", fmt::join(hash, "")); }

std::uint32_t id_from(const Sha256& hash) {
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < 4; ++i) id = (id << 8U) | hash[i];
  return id != 0 ? id : 1;
}

}  // namespace tripoint
