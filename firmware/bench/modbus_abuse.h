// Clients that do a Modbus server all the harm they can, while others are timed.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

namespace tripoint::bench {

/// From the addresses 127.0.0.2 on, until it is destroyed: some connect and leave at once, some hold half a request,
/// some send bytes without sense, some ask without end, and some ask without end and never read an answer. Whoever is
/// thrown out comes back at once.
class Abuse {
 public:
  explicit Abuse(std::uint16_t port);

 private:
  std::vector<std::jthread> threads_;
};

}  // namespace tripoint::bench
