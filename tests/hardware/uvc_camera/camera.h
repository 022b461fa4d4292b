// One simulated USB camera: answers its host's transfers over a USB/IP connection until it is unplugged.
#pragma once

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "controls.h"
#include "negotiation.h"
#include "payloads.h"
#include "usbip.h"

namespace tripoint::uvc {

class Camera {
 public:
  Camera(std::string serial, Pictures pictures, const Playlist& playlist, Time epoch);

  /// Waits for hosts on `listener`, one after the other: a connection is a cable that is in.
  void run(const Socket& listener, std::stop_token stop);

  // What the test may do to it, from another thread.
  void unplug() { unplugged_ = true; }
  void hang(bool hung) { hung_ = hung; }
  [[nodiscard]] std::string settings() const;

 private:
  void power_up();
  void serve(const Socket& host, const std::stop_token& stop);
  void fall_silent(const Socket& host, const std::stop_token& stop);
  [[nodiscard]] std::chrono::nanoseconds wait_time(Time now) const;
  [[nodiscard]] bool handle(const Socket& host, const Request& request);
  [[nodiscard]] bool stream(const Socket& host, Time now);
  [[nodiscard]] std::optional<Bytes> described(std::uint16_t what) const;
  std::optional<Bytes> answer_from_device(const Setup& setup);
  void select(std::uint8_t alternate);
  std::optional<Bytes> answer_from_interface(const Setup& setup, std::span<const std::uint8_t> sent);
  std::optional<Bytes> answer(const Setup& setup, std::span<const std::uint8_t> sent);

  std::string serial_;
  Pictures pictures_;
  Payloads payloads_;
  Negotiation negotiation_;
  mutable std::mutex settings_guard_;
  Controls controls_;
  std::uint8_t alternate_ = 0;  ///< of the streaming interface: 0 is off
  std::deque<Submit> waiting_;  ///< isochronous transfers to fill
  Time next_transfer_{};
  std::atomic<bool> unplugged_{false};
  std::atomic<bool> hung_{false};
};

}  // namespace tripoint::uvc
