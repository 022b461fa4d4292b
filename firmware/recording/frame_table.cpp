#include "recording/frame_table.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>

#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr std::string_view kRequiredColumns = "camera,index,exposure_mid_ns,arrival_ns";
constexpr std::size_t kMostColumns = 6;

using Cells = FixedVector<std::string_view, kMostColumns>;

/// Where the optional columns are; 0 = absent.
struct Columns {
  std::size_t count = 4;
  std::size_t forecast = 0;
  std::size_t event = 0;
};

std::optional<Columns> columns_of(std::string_view header) {
  if (!header.starts_with(kRequiredColumns)) return std::nullopt;
  const std::string_view rest = header.substr(kRequiredColumns.size());
  if (rest.empty()) return Columns{};
  if (rest == ",forecast") return Columns{5, 4, 0};
  if (rest == ",event") return Columns{5, 0, 4};
  if (rest == ",forecast,event") return Columns{6, 4, 5};
  return std::nullopt;
}

std::optional<Cells> cells_of(std::string_view line) {
  Cells cells;
  while (true) {
    const std::size_t comma = line.find(',');
    if (!cells.try_push_back(line.substr(0, comma))) return std::nullopt;
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

template <typename T>
std::optional<T> number_from(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Side> side_from(std::string_view text) {
  for (const Side side : kBothSides) {
    if (text == name(side)) return side;
  }
  return std::nullopt;
}

std::optional<RowKind> kind_from(std::string_view event) {
  if (event.empty()) return RowKind::kFrame;
  if (event == "lost") return RowKind::kCameraLost;
  if (event == "back") return RowKind::kCameraBack;
  return std::nullopt;
}

/// Reads row after row and remembers what came before.
class RowReader {
 public:
  RowReader(std::string_view file_name, Columns columns) : file_name_(file_name), columns_(columns) {}

  Result<RecordedRow> read(std::string_view text, std::size_t line) {
    line_ = line;
    const std::optional<Cells> cells = cells_of(text);
    if (!cells || cells->size() != columns_.count) return refuse(fmt::format("must have {} columns", columns_.count));
    RecordedRow row;
    row.line = line;
    const auto side = side_from((*cells)[0]);
    if (!side) return refuse("camera must be left or right");
    row.side = *side;
    const auto arrived = number_from<std::int64_t>((*cells)[3]);
    if (!arrived || *arrived < 0) return refuse("arrival_ns must be an integer from 0");
    row.arrived = row.exposed = time_from_ns(*arrived);
    const auto kind = kind_from(columns_.event == 0 ? std::string_view{} : (*cells)[columns_.event]);
    if (!kind) return refuse("event must be empty, lost or back");
    row.kind = *kind;
    return (row.kind == RowKind::kFrame ? with_frame(row, *cells) : Result<RecordedRow>(row))
        .and_then([this](const RecordedRow& read) { return in_order(read); });
  }

 private:
  [[nodiscard]] Result<RecordedRow> with_frame(RecordedRow row, const Cells& cells) const {
    const auto index = number_from<std::uint32_t>(cells[1]);
    if (!index) return refuse("index must be an integer from 0 to 4294967295");
    const auto exposed = number_from<std::int64_t>(cells[2]);
    if (!exposed || *exposed < 0) return refuse("exposure_mid_ns must be an integer from 0");
    row.index = *index;
    row.exposed = time_from_ns(*exposed);
    if (columns_.forecast == 0 || cells[columns_.forecast].empty()) return row;
    const auto forecast = number_from<std::uint64_t>(cells[columns_.forecast]);
    if (!forecast) return refuse("forecast must be empty or an integer from 0");
    row.forecast = *forecast;
    return row;
  }

  Result<RecordedRow> in_order(const RecordedRow& row) {
    std::optional<TimePoint>& arrived = last_arrived_[row.side];
    if (arrived && row.arrived < *arrived) return refuse("arrival_ns is before that of the camera's row above");
    arrived = row.arrived;
    if (row.kind != RowKind::kFrame) return row;
    std::optional<std::uint32_t>& index = last_index_[row.side];
    if (index && row.index <= *index) return refuse("index must be above that of the camera's row above");
    index = row.index;
    return row;
  }

  [[nodiscard]] tl::unexpected<Error> refuse(std::string_view why) const {
    return failure(ErrorCode::kMalformed, fmt::format("{}:{}: {}", file_name_, line_, why));
  }

  std::string_view file_name_;
  Columns columns_;
  std::size_t line_ = 0;
  PerSide<std::optional<TimePoint>> last_arrived_;
  PerSide<std::optional<std::uint32_t>> last_index_;
};

/// Takes the first line off the text, without its line end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

Result<std::vector<RecordedRow>> recorded_rows_from(std::string_view csv, std::string_view file_name) {
  const std::optional<Columns> columns = columns_of(take_line(csv));
  if (!columns) {
    return failure(ErrorCode::kMalformed,
                   fmt::format("{}:1: the header must be {}[,forecast][,event]", file_name, kRequiredColumns));
  }
  RowReader reader(file_name, *columns);
  std::vector<RecordedRow> rows;
  for (std::size_t line = 2; !csv.empty(); ++line) {
    Result<RecordedRow> row = reader.read(take_line(csv), line);
    if (!row) return tl::make_unexpected(row.error());
    rows.push_back(*row);
  }
  return rows;
}

}  // namespace tripoint
