#include "bench/modbus_abuse.h"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <stop_token>

#include "bench/loopback_socket.h"

namespace tripoint::bench {
namespace {

constexpr std::size_t kConnectionsEach = 8;  // of each kind: together they do not fill the server
constexpr auto kPause = std::chrono::microseconds(100);
constexpr std::size_t kPipelined = 20;
constexpr std::array<std::uint8_t, 12> kLargestRead{0, 1, 0, 0, 0, 6, 255, 3, 0, 0, 0, 125};

struct Deed {
  std::function<void(LoopbackSocket&)> at_first;
  std::function<void(LoopbackSocket&)> again_and_again;
};

void nothing(LoopbackSocket& /*socket*/) {}

void take_what_comes(LoopbackSocket& socket) {
  std::array<std::uint8_t, 4096> answers{};
  while (socket.receive(answers) > 0) {
  }
}

void ask(LoopbackSocket& socket) { socket.send(kLargestRead); }

void ask_much(LoopbackSocket& socket) {
  std::array<std::uint8_t, kPipelined * kLargestRead.size()> many{};
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = kLargestRead[i % kLargestRead.size()];
  socket.send(many);
}

void ask_by_half(LoopbackSocket& socket) { socket.send(std::span(kLargestRead).first(kLargestRead.size() / 2)); }

std::function<void(LoopbackSocket&)> babble() {
  return [random = std::minstd_rand(1)](LoopbackSocket& socket) mutable {
    std::array<std::uint8_t, 64> bytes{};
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() >> 8U);
    socket.send(bytes);
  };
}

void abuse(const std::stop_token& stop, std::uint16_t port, std::uint8_t from, const Deed& deed) {
  std::array<std::unique_ptr<LoopbackSocket>, kConnectionsEach> sockets;
  while (!stop.stop_requested()) {
    for (auto& socket : sockets) {
      if (!socket || !socket->open()) {
        socket = std::make_unique<LoopbackSocket>(port, from);
        deed.at_first(*socket);
      }
      deed.again_and_again(*socket);
    }
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

Abuse::Abuse(std::uint16_t port) {
  const std::array<Deed, 5> deeds{Deed{ask, [](LoopbackSocket& socket) { socket.give_up(); }},
                                  Deed{ask_by_half, take_what_comes}, Deed{babble(), take_what_comes},
                                  Deed{nothing,
                                       [](LoopbackSocket& socket) {
                                         ask(socket);
                                         take_what_comes(socket);
                                       }},
                                  Deed{nothing, ask_much}};
  std::uint8_t from = 2;
  for (const Deed& deed : deeds) {
    threads_.emplace_back([=](const std::stop_token& stop) { abuse(stop, port, from, deed); });
    ++from;
  }
}

}  // namespace tripoint::bench
