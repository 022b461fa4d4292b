#include "net/modbus_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <ctime>
#include <thread>
#include <utility>

#include "net/admission.h"
#include "net/asio_address.h"
#include "net/client_watch.h"
#include "net/connection.h"
#include "net/work_share.h"

namespace tripoint {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr Duration kLongestSweep{100'000'000};  // deadlines are held to this, or to an eighth of the shortest one
constexpr Duration kAcceptRetry{100'000'000};   // when the system has no descriptor for a newcomer
constexpr int kSendBufferBytes = 32 * 1024;     // what a client that does not read can hold in the kernel

struct AtomicCounters {
  std::atomic<std::uint64_t> accepted{0}, refused{0}, displaced{0}, timed_out{0}, broken{0}, requests{0}, internal{0};
  std::atomic<std::uint16_t> connected{0};
};

Error open_error(const ModbusSettings& settings, const error_code& error) {
  const std::string where = fmt::format("modbus: {}:{}: ", settings.address, settings.port);
  if (error == boost::asio::error::address_in_use) {
    return {ErrorCode::kAddressInUse, where + "the port is in use; stop the other program or set modbus.port"};
  }
  if (error == boost::asio::error::access_denied) {
    return {ErrorCode::kOutOfRange, where + "not permitted; ports below 1024 need CAP_NET_BIND_SERVICE"};
  }
  if (error == boost::system::errc::address_not_available) {
    return {ErrorCode::kOutOfRange, where + "not an address of this machine; set modbus.address"};
  }
  return {ErrorCode::kDeviceFault, where + error.message()};
}

Duration processor_time_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + Duration{time.tv_nsec};
}

Duration sweep_period(const ModbusSettings& settings) {
  const Duration shortest = std::min({settings.frame_limit, settings.write_limit, settings.idle_limit});
  return std::clamp(shortest / 8, Duration{1'000'000}, kLongestSweep);
}

}  // namespace

class ModbusServer::Impl {
 public:
  Impl(ModbusSettings settings, Responder& responder, Now now, Say say)
      : settings_(std::move(settings)),
        responder_(responder),
        now_(std::move(now)),
        say_(std::move(say)),
        host_{now_, [this](auto request, const Connection& client) { return answer(request, client); },
              [this](const Connection& client, bool broken) { closed(client, broken); }} {}

  error_code listen() {
    error_code error;
    const auto address = boost::asio::ip::make_address(settings_.address, error);
    if (error) return boost::system::errc::make_error_code(boost::system::errc::address_not_available);
    const tcp::endpoint endpoint(address, settings_.port);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
    if (!error) port_ = acceptor_.local_endpoint(error).port();
    return error;
  }

  void run(const std::stop_token& stop) {
    accept();
    sweep();
    const std::stop_callback on_stop(stop, [this] { io_.stop(); });
    WorkShare share;
    while (!io_.stopped()) {
      try {
        io_.run_one();
      } catch (const std::exception&) {
        ++counters_.internal;  // out of memory: the client it befell is swept at its deadline, the others go on
      }
      const Duration rest = share.rest_after(processor_time_of_thread(), now_());
      if (rest > Duration{0}) std::this_thread::sleep_for(rest);
    }
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }

  [[nodiscard]] ModbusCounters counters() const {
    return {counters_.accepted, counters_.refused,  counters_.displaced, counters_.timed_out,
            counters_.broken,   counters_.requests, counters_.internal,  counters_.connected};
  }

 private:
  void accept() {
    acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
      if (!error) {
        accept();
        return welcome(std::move(socket));
      }
      if (error == boost::asio::error::operation_aborted) return;
      ++counters_.internal;
      retry_.expires_after(kAcceptRetry);
      retry_.async_wait([this](const error_code& aborted) {
        if (!aborted) accept();
      });
    });
  }

  void welcome(tcp::socket socket) {
    error_code error;
    const tcp::endpoint peer = socket.remote_endpoint(error);
    if (error) return;  // it has gone already
    const ClientAddress address = client_address_of(peer.address());
    if (!settings_.allowed_clients.empty() && !any_contains(settings_.allowed_clients, address)) return refuse();
    std::vector<Present> present;
    for (const auto& connection : connections_) {
      present.push_back({connection->address(), connection->last_heard(), connection->has_asked()});
    }
    const Admission admission = admission_of(address, present, settings_.most_connections);
    if (!admission.admitted) return refuse();
    if (admission.displaced) {
      const auto displaced = connections_[*admission.displaced];
      ++counters_.displaced;
      refused_at_ = now_();
      displaced->close();
    }
    socket.set_option(tcp::no_delay(true), error);
    socket.set_option(boost::asio::socket_base::keep_alive(true), error);
    socket.set_option(boost::asio::socket_base::send_buffer_size(kSendBufferBytes), error);
    const auto connection = std::make_shared<Connection>(
        std::move(socket), address, any_contains(settings_.command_clients, address), host_,
        ConnectionLimits{settings_.frame_limit, settings_.write_limit, settings_.idle_limit, settings_.request_pace});
    connections_.push_back(connection);
    ++counters_.accepted;
    counters_.connected = static_cast<std::uint16_t>(connections_.size());
    connection->start();
  }

  void refuse() {
    ++counters_.refused;
    refused_at_ = now_();
  }

  Pdu answer(std::span<const std::uint8_t> request, const Connection& client) {
    ++counters_.requests;
    Asker asker{now_(), client.may_command(), counters_.connected, {}};
    if (refused_at_ && asker.now - *refused_at_ < kWarningHold) asker.warnings.insert(Warning::kRefusedClients);
    return responder_.answer(request, asker);
  }

  void closed(const Connection& client, bool broken) {
    if (broken) ++counters_.broken;
    std::erase_if(connections_, [&](const auto& connection) { return connection.get() == &client; });
    counters_.connected = static_cast<std::uint16_t>(connections_.size());
  }

  void sweep() {
    const TimePoint now = now_();
    const auto all = connections_;  // closing takes them off the list
    for (const auto& connection : all) {
      if (now <= connection->deadline()) continue;
      ++counters_.timed_out;
      connection->close();
    }
    if (const auto news = watch_.news(counters(), now)) say_(*news);
    sweep_.expires_after(sweep_period(settings_));
    sweep_.async_wait([this](const error_code& aborted) {
      if (!aborted) sweep();
    });
  }

  ModbusSettings settings_;
  Responder& responder_;
  Now now_;
  Say say_;
  ConnectionHost host_;
  AtomicCounters counters_;
  ClientWatch watch_;
  std::optional<TimePoint> refused_at_;
  std::uint16_t port_ = 0;
  boost::asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  boost::asio::steady_timer sweep_{io_};
  boost::asio::steady_timer retry_{io_};
  std::vector<std::shared_ptr<Connection>> connections_;  // shared with the operation that each waits for
};

Result<ModbusServer> ModbusServer::open(const ModbusSettings& settings, Responder& responder, Now now, Say say) {
  try {
    auto impl = std::make_unique<Impl>(settings, responder, std::move(now), std::move(say));
    if (const error_code error = impl->listen()) return tl::make_unexpected(open_error(settings, error));
    return ModbusServer(std::move(impl));
  } catch (const boost::system::system_error& error) {
    return tl::make_unexpected(open_error(settings, error.code()));
  }
}

ModbusServer::ModbusServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ModbusServer::ModbusServer(ModbusServer&&) noexcept = default;
ModbusServer& ModbusServer::operator=(ModbusServer&&) noexcept = default;
ModbusServer::~ModbusServer() = default;

void ModbusServer::run(const std::stop_token& stop) { impl_->run(stop); }
std::uint16_t ModbusServer::port() const { return impl_->port(); }
ModbusCounters ModbusServer::counters() const { return impl_->counters(); }

}  // namespace tripoint
