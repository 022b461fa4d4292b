#include "bench/modbus_load.h"

#include <sys/epoll.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "bench/loopback_socket.h"

namespace tripoint::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kRegisters = 116;
constexpr std::size_t kHeader = 9;  // MBAP, function, byte count
constexpr std::size_t kAnswer = kHeader + 2 * kRegisters;
constexpr std::array<std::uint8_t, 12> kRequest{0, 1, 0, 0, 0, 6, 255, 3, 0, 32, 0, kRegisters};

class Poller {
 public:
  explicit Poller(std::uint16_t port) : socket_(port) {}

  [[nodiscard]] int descriptor() const { return socket_.descriptor(); }
  [[nodiscard]] bool open() const { return socket_.open(); }
  [[nodiscard]] bool waiting() const { return waiting_; }

  void ask(Clock::time_point due) {
    due_ = due;
    waiting_ = true;
    socket_.send(kRequest);
  }

  /// @return true when the answer is whole
  bool take() {
    have_ += socket_.receive(std::span(answer_).subspan(have_));
    if (have_ < kAnswer) return false;
    have_ = 0;
    waiting_ = false;
    return true;
  }

  [[nodiscard]] float since_due_ms() const {
    return std::chrono::duration<float, std::milli>(Clock::now() - due_).count();
  }

  [[nodiscard]] std::array<std::uint16_t, kRegisters> registers() const {
    std::array<std::uint16_t, kRegisters> words{};
    for (std::size_t i = 0; i < kRegisters; ++i) {
      words[i] = static_cast<std::uint16_t>(answer_[kHeader + 2 * i] << 8U | answer_[kHeader + 2 * i + 1]);
    }
    return words;
  }

  Clock::time_point next{};  ///< when the next request is due

 private:
  LoopbackSocket socket_;
  bool waiting_ = false;
  Clock::time_point due_{};
  std::array<std::uint8_t, kAnswer> answer_{};
  std::size_t have_ = 0;
};

using Pollers = std::vector<std::unique_ptr<Poller>>;

void take_answers(const Pollers& pollers, int epoll, const AnswerCheck& check, LoadResult& result) {
  std::array<epoll_event, 64> events{};
  const int ready = epoll_wait(epoll, events.data(), static_cast<int>(events.size()), 1);
  for (int i = 0; i < ready; ++i) {
    Poller& poller = *pollers[events[static_cast<std::size_t>(i)].data.u32];
    const bool was_open = poller.open();
    if (poller.take()) {
      result.times_ms.push_back(poller.since_due_ms());
      if (!check(poller.registers())) ++result.torn;
    } else if (was_open && !poller.open()) {
      ++result.lost;
    }
  }
}

void ask_what_is_due(const Pollers& pollers, std::chrono::microseconds period) {
  const Clock::time_point now = Clock::now();
  for (const auto& poller : pollers) {
    if (poller->waiting() || !poller->open() || now < poller->next) continue;
    // Late by a whole period because the answer before was: the wait counts from when this one was due.
    const bool held_up = period.count() > 0 && now - poller->next > period;
    poller->ask(held_up ? poller->next : now);
    poller->next += period;
  }
}

}  // namespace

bool sequences_agree(std::span<const std::uint16_t> registers_from_32) {
  return registers_from_32[100 - 32] == registers_from_32[147 - 32];
}

Result<LoadResult> load(const LoadPlan& plan, const AnswerCheck& check) {
  const int epoll = epoll_create1(0);
  Pollers pollers;
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < plan.clients; ++i) {
    pollers.push_back(std::make_unique<Poller>(plan.port));
    if (!pollers.back()->open()) {
      return failure(ErrorCode::kDeviceMissing, "127.0.0.1:" + std::to_string(plan.port) + ": nobody listens");
    }
    pollers.back()->next = start + plan.period * i / plan.clients;
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u32 = static_cast<std::uint32_t>(i);
    epoll_ctl(epoll, EPOLL_CTL_ADD, pollers.back()->descriptor(), &event);
  }
  LoadResult result;
  while (Clock::now() - start < plan.duration && result.times_ms.size() < plan.most_answers) {
    ask_what_is_due(pollers, plan.period);
    take_answers(pollers, epoll, check, result);
  }
  ::close(epoll);
  return result;
}

}  // namespace tripoint::bench
