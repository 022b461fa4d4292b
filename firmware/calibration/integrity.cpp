#include "calibration/integrity.h"

#include <algorithm>
#include <optional>

#include "document/sha256.h"

namespace tripoint {
namespace {

constexpr std::string_view kHeader = "[integrity]";

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// All bytes before the header, if it stands alone on its line and no other header follows.
std::optional<std::string_view> protected_part(std::string_view text) {
  std::optional<std::string_view> before;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (line.starts_with(kHeader) && trimmed(line) == kHeader) {
      before = text.substr(0, at);
    } else if (trimmed(line).starts_with('[')) {
      before = std::nullopt;
    }
    at = end + 1;
  }
  return before;
}

}  // namespace

void check_integrity(TableReader& root, std::string_view text) {
  if (!root.has("integrity")) return;
  TableReader table = root.table("integrity");
  const std::string stated = table.text("sha256");
  table.finish();
  const std::optional<std::string_view> bytes = protected_part(text);
  if (!bytes) {
    root.refuse("integrity", "permitted is the last table, its header [integrity] alone on a line");
  } else if (hex_from(sha256(*bytes)) != stated) {
    table.refuse("sha256",
                 "the file is damaged or was edited; permitted is the SHA-256 of all bytes before [integrity], "
                 "or no [integrity]");
  }
}

}  // namespace tripoint
