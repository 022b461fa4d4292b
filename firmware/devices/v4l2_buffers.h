// The driver's frame buffers, mapped into memory, and the stream that fills them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "devices/v4l2_device.h"
#include "values/time.h"

namespace tripoint {

/// Memory shared with the driver; one owner.
class MappedBuffer {
 public:
  MappedBuffer(void* memory, std::size_t length) : memory_(memory), length_(length) {}
  MappedBuffer(MappedBuffer&& other) noexcept;
  MappedBuffer& operator=(MappedBuffer&& other) noexcept;
  ~MappedBuffer();

  [[nodiscard]] std::span<const std::uint8_t> bytes() const {
    return {static_cast<const std::uint8_t*>(memory_), length_};
  }

 private:
  void* memory_;
  std::size_t length_;
};

/// One buffer as the driver gave it back.
struct FilledBuffer {
  std::uint32_t index = 0;
  std::span<const std::uint8_t> bytes;
  std::uint32_t sequence = 0;
  std::optional<TimePoint> stamp;  ///< nothing when the driver's stamp is not of the monotonic clock
  bool damaged = false;            ///< the driver marked it so
};

/// A stream that is on as long as this exists.
class V4l2Buffers {
 public:
  /// Takes the device over, maps its buffers, hands all of them to the driver and starts the stream.
  ///
  /// @return errors of V4l2Device (kNoBandwidth when the bus is full); kDeviceFault with fewer than two buffers
  static Result<V4l2Buffers> start(V4l2Device device);

  V4l2Buffers(V4l2Buffers&&) = default;
  V4l2Buffers& operator=(V4l2Buffers&&) = delete;
  ~V4l2Buffers();

  /// Takes the newest filled buffer and gives older ones back to the driver.
  ///
  /// @return nothing when none is filled; kCorruptFrame when the driver lost the only one; errors of V4l2Device
  Result<std::optional<FilledBuffer>> newest();
  /// Lets the driver fill the buffer again.
  Result<void> give_back(std::uint32_t index);

  [[nodiscard]] const V4l2Device& device() const { return device_; }

 private:
  explicit V4l2Buffers(V4l2Device device) : device_(std::move(device)) {}
  Result<void> map_all();
  Result<void> switch_on();
  Result<std::optional<FilledBuffer>> take_one();

  V4l2Device device_;
  std::vector<MappedBuffer> buffers_;
};

}  // namespace tripoint
