#include "net/connection.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

#include "contract/registers.h"

namespace tripoint {
namespace {

// A client that was quiet may send so much at once before it is paced.
constexpr Duration kBurst = std::chrono::milliseconds(registers::server::kBurstMs);

}  // namespace

Connection::Connection(boost::asio::ip::tcp::socket socket, const ClientAddress& address, bool may_command,
                       const ConnectionHost& host, const ConnectionLimits& limits)
    : socket_(std::move(socket)),
      pause_(socket_.get_executor()),
      address_(address),
      may_command_(may_command),
      host_(host),
      limits_(limits),
      last_heard_(host.now()) {}

void Connection::start() { read(); }

void Connection::close() { shut(false); }

void Connection::shut(bool broken) {
  if (!socket_.is_open()) return;
  boost::system::error_code ignored;  // the peer may have gone before us
  socket_.shutdown(boost::asio::ip::tcp::socket::shutdown_both, ignored);
  socket_.close(ignored);
  pause_.cancel();
  host_.closed(*this, broken);
}

void Connection::read() {
  if (!partial_) deadline_ = host_.now() + limits_.idle;
  const auto free_space = boost::asio::buffer(input_.data() + have_, input_.size() - have_);
  socket_.async_read_some(free_space, [self = shared_from_this()](const auto& error, std::size_t bytes) {
    if (error) return self->close();
    self->taken(bytes);
  });
}

void Connection::taken(std::size_t bytes) {
  have_ += bytes;
  take_turn();
}

void Connection::take_turn() {
  const TimePoint now = host_.now();
  turn_ = turn_of({input_.data(), have_}, [this](auto request) { return host_.answer(request, *this); });
  std::copy(input_.begin() + static_cast<std::ptrdiff_t>(turn_.consumed),
            input_.begin() + static_cast<std::ptrdiff_t>(have_), input_.begin());
  have_ -= turn_.consumed;
  if (turn_.requests > 0) {
    last_heard_ = now;
    has_asked_ = true;
  }
  const bool begins = !partial_ || turn_.requests > 0;
  partial_ = have_ > 0 && !turn_.more;
  if (partial_ && begins) deadline_ = now + limits_.frame;
  if (turn_.requests > 0) {
    send();
  } else if (turn_.broken) {
    shut(true);
  } else {
    read();
  }
}

void Connection::send() {
  deadline_ = host_.now() + limits_.write;
  boost::asio::async_write(socket_, boost::asio::buffer(turn_.output.begin(), turn_.output.size()),
                           [self = shared_from_this()](const auto& error, std::size_t) {
                             if (error) return self->close();
                             self->sent();
                           });
}

void Connection::sent() {
  if (turn_.broken) return shut(true);
  const TimePoint now = host_.now();
  paid_until_ = std::max(paid_until_, now - kBurst) + limits_.pace * static_cast<std::int64_t>(turn_.requests);
  deadline_ = std::max(now, paid_until_) + limits_.frame;
  if (paid_until_ <= now) return go_on();
  pause_.expires_after(paid_until_ - now);
  pause_.async_wait([self = shared_from_this()](const auto& error) {
    if (!error && self->socket_.is_open()) self->go_on();
  });
}

void Connection::go_on() {
  if (turn_.more) {
    take_turn();
  } else {
    read();
  }
}

}  // namespace tripoint
