// Any bytes as recording.toml or frames.csv (told apart by the first byte): refused with a message, or in order.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "recording/frame_table.h"
#include "recording/recording_description.h"

namespace {

void check(bool condition) {
  if (!condition) std::abort();
}

void fuzz_table(std::string_view text) {
  const auto rows = tripoint::recorded_rows_from(text, "frames.csv");
  if (!rows) {
    check(!rows.error().message.empty());
    return;
  }
  std::size_t line = 1;
  for (const tripoint::RecordedRow& row : *rows) check(row.line == ++line);
}

void fuzz_description(std::string_view text) {
  const auto description = tripoint::recording_description_from(text, "recording.toml");
  if (!description) {
    check(!description.error().message.empty());
    return;
  }
  check(description->size.width_px >= 16 && description->size.height_px <= 4096);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with('c')) {
    fuzz_table(text);
  } else {
    fuzz_description(text);
  }
  return 0;
}
