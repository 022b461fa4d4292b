#include "recording/recorded_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tripoint {
namespace {

TimePoint first_arrival(std::span<const RecordedRow> rows) {
  TimePoint first = TimePoint::max();
  for (const RecordedRow& row : rows) first = std::min(first, row.arrived);
  return first;
}

double rate_of(const std::vector<RecordedRow>& frames) {
  if (frames.size() < 2) return 0.0;
  const double span_s = seconds(frames.back().arrived - frames.front().arrived);
  return span_s > 0.0 ? static_cast<double>(frames.size() - 1) / span_s : 0.0;
}

}  // namespace

Result<RecordedCamera::Opener> RecordedCamera::opener(const std::filesystem::path& folder, Side side,
                                                      const Playback& playback) {
  const Result<RecordingReader> tried = RecordingReader::open(folder);
  if (!tried) return tl::make_unexpected(tried.error());
  const auto position = std::make_shared<Position>();  // shared: the next opening goes on from here
  return [folder, side, playback, position]() -> Result<std::unique_ptr<Camera>> {
    Result<RecordingReader> reader = RecordingReader::open(folder);
    if (!reader) return tl::make_unexpected(reader.error());
    return std::unique_ptr<Camera>(new RecordedCamera(std::move(*reader), side, playback, position));
  };
}

RecordedCamera::RecordedCamera(RecordingReader reader, Side side, Playback playback, std::shared_ptr<Position> position)
    : reader_(std::move(reader)), playback_(std::move(playback)), position_(std::move(position)) {
  for (const RecordedRow& row : reader_.rows()) {
    if (row.side == side && row.kind == RowKind::kFrame) rows_.push_back(row);
  }
  shift_ = rows_.empty() ? Duration{0} : playback_.start - first_arrival(reader_.rows());
  info_.name = fmt::format("{} (recording {})", name(side), reader_.folder().string());
  info_.size = reader_.description().size;
  info_.format = reader_.description().format == RecordedFormat::kJpg ? PixelFormat::kMjpeg : PixelFormat::kYuyv;
  info_.rate_hz = rate_of(rows_);
}

Result<Frame> RecordedCamera::next_frame(Duration limit) {
  std::size_t& row = position_->row;
  if (row >= rows_.size()) {
    return failure(ErrorCode::kEndOfStream, fmt::format("{}: has ended after {} frames; start again to play it again",
                                                        info_.name, rows_.size()));
  }
  const TimePoint deadline = playback_.clock.now() + limit;
  if (due(row) > deadline) {
    playback_.wait_until(deadline);
    return failure(ErrorCode::kTimeout,
                   fmt::format("{}: has no frame for {:.0f} ms", info_.name, 1e3 * seconds(limit)));
  }
  playback_.wait_until(due(row));
  while (row + 1 < rows_.size() && due(row + 1) <= playback_.clock.now()) ++row;
  Result<Frame> frame = reader_.frame(rows_[row++]);
  if (!frame) return failure(ErrorCode::kCorruptFrame, frame.error().message);
  frame->exposed += shift_;
  frame->arrived += shift_;
  return frame;
}

}  // namespace tripoint
