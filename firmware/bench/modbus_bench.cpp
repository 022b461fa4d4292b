// Figures of the Modbus server: torn reads, and how long clients that poll at 50 Hz wait for their answers: 64 of them,
// and eight while others abuse the server.
//
// usage: bench_modbus                             torn reads, with a server of its own
//        bench_modbus --connect PORT --seconds S  the waiting, with a running tripointd
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "bench/figure.h"
#include "bench/modbus_abuse.h"
#include "bench/modbus_load.h"
#include "devices/realtime.h"
#include "net/modbus_server.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kReads = 1'000'000;
constexpr auto kPublishingPeriod = std::chrono::microseconds(20);
constexpr std::int64_t kExposureStep_ns = 1'000;  // of one sequence number: so time tells the sequence
constexpr int kServerPriority = 20;
constexpr int kClientPriority = 10;  // a PLC has its own processor: its own delays are not the server's

TimePoint monotonic_now() { return std::chrono::time_point_cast<Duration>(std::chrono::steady_clock::now()); }

/// A state whose every number follows from its sequence, so that a mixture of two shows.
UnitState state_of(std::uint32_t sequence, TimePoint epoch) {
  UnitState state;
  state.heartbeat = static_cast<std::uint16_t>(sequence);
  state.limits.age_limit = std::chrono::hours(1);
  state.exposure_since_start = true;
  state.pose_since_start = true;
  Measurement measurement;
  measurement.sequence = sequence;
  measurement.exposed = epoch + Duration{kExposureStep_ns * sequence};
  const double x_mm = 1e-3 * (sequence % 1'000'000);
  measurement.pose = TargetPose{Vec3(x_mm, -x_mm, 500.0 + x_mm), std::nullopt, Matrix6::Zero(), Matrix6::Zero()};
  state.newest = PublishedMeasurement{measurement, Duration{0} - epoch.time_since_epoch()};
  return state;
}

std::uint64_t number_at(std::span<const std::uint16_t> registers_from_32, std::size_t address, std::size_t words) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < words; ++i) number = number << 16U | registers_from_32[address - 32 + i];
  return number;
}

/// Every number of the answer belongs to one sequence.
bool is_whole(std::span<const std::uint16_t> answer) {
  const std::uint64_t sequence = number_at(answer, 144, 2);
  const auto x_um = static_cast<std::uint32_t>(sequence % 1'000'000);
  return sequences_agree(answer) && number_at(answer, 100, 1) == (sequence & 0xFFFFU) &&
         number_at(answer, 32, 1) == (sequence & 0xFFFFU) && number_at(answer, 104, 4) == sequence * kExposureStep_ns &&
         number_at(answer, 110, 2) == x_um && number_at(answer, 112, 2) == (0U - x_um) &&
         number_at(answer, 114, 2) == 500'000U + x_um;
}

/// A server that does not hold its clients back, with a publisher beside it.
class Unit {
 public:
  Unit()
      : epoch_(monotonic_now()),
        publication_(state_of(1, epoch_)),
        server_(open()),
        serving_([this](const std::stop_token& stop) {
          if (const auto note = take_realtime_priority(kServerPriority); !note) {
            std::fprintf(stderr, "%s\n", note.error().message.c_str());
          }
          server_.run(stop);
        }),
        publishing_([this](const std::stop_token& stop) {
          for (std::uint32_t sequence = 2; !stop.stop_requested(); ++sequence) {
            publication_.publish(state_of(sequence, epoch_), monotonic_now());
            std::this_thread::sleep_for(kPublishingPeriod);
          }
        }) {}

  [[nodiscard]] std::uint16_t port() const { return server_.port(); }

 private:
  ModbusServer open() {
    ModbusSettings settings;
    settings.port = 0;
    settings.request_pace = Duration{0};
    return ModbusServer::open(settings, responder_, monotonic_now, [](std::string_view) {}).value();
  }

  TimePoint epoch_;
  Publication publication_;
  Responder responder_{publication_, DeviceIdentification{}};
  ModbusServer server_;
  std::jthread serving_;
  std::jthread publishing_;
};

Figure torn_reads() {
  const Unit unit;
  const LoadPlan plan{unit.port(), 32, std::chrono::microseconds(0), std::chrono::seconds(120), kReads};
  const LoadResult result = load(plan, is_whole).value();
  if (result.times_ms.size() < kReads || result.lost > 0) {
    std::fprintf(stderr, "bench_modbus: only %zu of %llu reads\n", result.times_ms.size(),
                 static_cast<unsigned long long>(kReads));
    std::exit(1);
  }
  return at_most({.name = "torn_reads", .value = static_cast<double>(result.torn), .unit = "reads"}, 0.0);
}

/// Round trips under a load in which no answer may be lost or torn.
class Waiting {
 public:
  Waiting(const LoadPlan& plan, const char* label) : times_ms_(times_under(plan)) {
    std::fprintf(stderr, "%s: %zu answers, p50 %.3f ms, p99 %.3f ms, largest %.3f ms\n", label, times_ms_.size(),
                 at(0.5), at(0.99), at(1.0));
  }

  [[nodiscard]] double at(double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(times_ms_.size() - 1));
    std::nth_element(times_ms_.begin(), times_ms_.begin() + place, times_ms_.end());
    return static_cast<double>(times_ms_[static_cast<std::size_t>(place)]);
  }

 private:
  static std::vector<float> times_under(const LoadPlan& plan) {
    (void)take_realtime_priority(kClientPriority);  // without it the figure only gets worse
    const auto result = load(plan, sequences_agree);
    if (!result || result->lost > 0 || result->torn > 0 || result->times_ms.size() < 100) {
      std::fprintf(stderr, "bench_modbus: %s\n", result ? "answers were lost or torn" : result.error().message.c_str());
      std::exit(1);
    }
    return result->times_ms;
  }

  std::vector<float> times_ms_;
};

Figure waiting(std::uint16_t port, std::chrono::seconds duration) {
  Waiting waiting({.port = port, .duration = duration}, "modbus");
  return at_most({.name = "modbus_64_clients_p99_ms", .value = waiting.at(0.99), .unit = "ms"}, 5.0);
}

/// Connections of the abusers and of those who are timed stay below what the server takes.
Figure waiting_under_abuse(std::uint16_t port, std::chrono::seconds duration) {
  const Abuse abuse(port);
  Waiting waiting({.port = port, .clients = 8, .duration = duration}, "modbus under abuse");
  return at_most({.name = "modbus_abuse_largest_ms", .value = waiting.at(1.0), .unit = "ms"}, 100.0);
}

int run(int count, char** words) {
  std::uint16_t port = 0;
  std::chrono::seconds duration{10};
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view option = words[i];
    if (option == "--connect") port = static_cast<std::uint16_t>(std::atoi(words[i + 1]));
    if (option == "--seconds") duration = std::chrono::seconds(std::atoi(words[i + 1]));
  }
  if (count % 2 == 0) {
    std::fputs("usage: bench_modbus [--connect PORT] [--seconds S]\n", stderr);
    return 2;
  }
  std::vector<Figure> figures;
  if (port == 0) {
    figures.push_back(torn_reads());
  } else {
    figures.push_back(waiting(port, duration));
    figures.push_back(waiting_under_abuse(port, duration));
  }
  print(figures);
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) { return tripoint::bench::run(count, words); }
