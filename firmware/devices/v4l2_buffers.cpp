#include "devices/v4l2_buffers.h"

#include <fmt/format.h>
#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace tripoint {
namespace {

// One is held by the detector, one is being filled, one is full: the fourth bears a late wake-up.
constexpr std::uint32_t kWantedBuffers = 4;
constexpr std::uint32_t kLeastBuffers = 2;

v4l2_buffer capture_buffer(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

std::optional<TimePoint> monotonic_stamp(const v4l2_buffer& buffer) {
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) return std::nullopt;
  return TimePoint{std::chrono::seconds(buffer.timestamp.tv_sec) + std::chrono::microseconds(buffer.timestamp.tv_usec)};
}

}  // namespace

MappedBuffer::MappedBuffer(MappedBuffer&& other) noexcept
    : memory_(std::exchange(other.memory_, nullptr)), length_(std::exchange(other.length_, 0)) {}

MappedBuffer& MappedBuffer::operator=(MappedBuffer&& other) noexcept {
  std::swap(memory_, other.memory_);
  std::swap(length_, other.length_);
  return *this;
}

MappedBuffer::~MappedBuffer() {
  if (memory_ != nullptr) ::munmap(memory_, length_);
}

Result<V4l2Buffers> V4l2Buffers::start(V4l2Device device) {
  V4l2Buffers buffers(std::move(device));
  const Result<void> started = buffers.map_all().and_then([&] { return buffers.switch_on(); });
  if (!started) return tl::make_unexpected(started.error());
  return buffers;
}

V4l2Buffers::~V4l2Buffers() {
  if (buffers_.empty()) return;  // moved from, or never started
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  device_.try_control(VIDIOC_STREAMOFF, type);
}

Result<void> V4l2Buffers::map_all() {
  v4l2_requestbuffers request{};
  request.count = kWantedBuffers;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  const Result<void> requested = device_.control(VIDIOC_REQBUFS, request, "get frame buffers");
  if (!requested) return requested;
  if (request.count < kLeastBuffers) {
    return failure(ErrorCode::kDeviceFault, fmt::format("{}: the driver gave {} frame buffers, needed are {}",
                                                        device_.name(), request.count, kLeastBuffers));
  }
  for (std::uint32_t i = 0; i < request.count; ++i) {
    v4l2_buffer buffer = capture_buffer(i);
    const Result<void> queried = device_.control(VIDIOC_QUERYBUF, buffer, "describe a frame buffer");
    if (!queried) return queried;
    void* memory = device_.map(buffer.length, buffer.m.offset);
    if (memory == nullptr) return tl::make_unexpected(device_.error(-ENOMEM, "map a frame buffer"));
    buffers_.emplace_back(memory, buffer.length);
  }
  return {};
}

Result<void> V4l2Buffers::switch_on() {
  for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
    const Result<void> given = give_back(i);
    if (!given) return given;
  }
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  const int started = device_.try_control(VIDIOC_STREAMON, type);
  if (started == 0) return {};
  Error error = device_.error(started, "start streaming");
  if (started == -EIO) error.message += "; no USB transfer mode may be fast enough for the format: ask for less";
  return tl::make_unexpected(error);
}

Result<void> V4l2Buffers::give_back(std::uint32_t index) {
  v4l2_buffer buffer = capture_buffer(index);
  return device_.control(VIDIOC_QBUF, buffer, "give a frame buffer to the driver");
}

Result<std::optional<FilledBuffer>> V4l2Buffers::newest() {
  std::optional<FilledBuffer> held;
  while (true) {
    const Result<std::optional<FilledBuffer>> taken = take_one();
    if (!taken && held && taken.error().code == ErrorCode::kCorruptFrame) return held;
    if (!taken) return taken;
    if (!*taken) return held;
    if (held) {
      const Result<void> given = give_back(held->index);
      if (!given) return tl::make_unexpected(given.error());
    }
    held = *taken;
  }
}

Result<std::optional<FilledBuffer>> V4l2Buffers::take_one() {
  v4l2_buffer buffer = capture_buffer(0);
  const int result = device_.try_control(VIDIOC_DQBUF, buffer);
  if (result == -EAGAIN) return std::optional<FilledBuffer>{};
  if (result == -EIO) return failure(ErrorCode::kCorruptFrame, device_.name() + ": the driver lost a frame");
  if (result < 0) return tl::make_unexpected(device_.error(result, "fetch a frame"));
  if (buffer.index >= buffers_.size()) {
    return failure(ErrorCode::kDeviceFault, fmt::format("{}: no frame buffer {}", device_.name(), buffer.index));
  }
  const std::span<const std::uint8_t> whole = buffers_[buffer.index].bytes();
  return FilledBuffer{.index = buffer.index,
                      .bytes = whole.first(std::min<std::size_t>(buffer.bytesused, whole.size())),
                      .sequence = buffer.sequence,
                      .stamp = monotonic_stamp(buffer),
                      .damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0};
}

}  // namespace tripoint
