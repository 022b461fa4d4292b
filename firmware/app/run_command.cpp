#include "app/run_command.h"

#include <fmt/core.h>
#include <pthread.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <memory>
#include <mutex>

#include "app/camera_supply.h"
#include "app/composition.h"
#include "app/exit_code.h"
#include "app/unit_setup.h"
#include "app/version.h"
#include "config/config.h"
#include "devices/system_clock.h"
#include "devices/unblocked_output.h"

namespace tripoint {
namespace {

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

void wait_for_stop_signal() {
  const sigset_t signals = stop_signals();
  int received = 0;
  sigwait(&signals, &received);
}

constexpr int kStderr = 2;  // POSIX

/// A log that nobody reads stops nothing.
class UnblockedSink : public spdlog::sinks::base_sink<std::mutex> {
 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    output_.write({line.data(), line.size()});
  }
  void flush_() override {}

  UnblockedOutput output_{kStderr};
};

void log_to_stderr() {
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("tripointd", std::make_shared<UnblockedSink>()));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
}

}  // namespace

int run_command(const std::filesystem::path& config_file, const std::vector<std::string>& overrides) {
  const sigset_t signals = stop_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before any thread exists, so that only this one takes them
  const Result<Config> config = load_config(config_file, overrides);
  if (!config) return report(config.error());
  log_to_stderr();
  spdlog::info("tripointd {} with {}", version_text(), config_file.string());
  const Result<void> ran = run_unit(*config, wait_for_stop_signal);
  return ran ? number(ExitCode::kWell) : report(ran.error());
}

int check_config_command(const std::filesystem::path& config_file, const std::vector<std::string>& overrides) {
  const Result<Config> config = load_config(config_file, overrides);
  if (!config) return report(config.error());
  const Result<UnitSetup> setup = unit_setup(*config);
  if (!setup) return report(setup.error());
  const SystemClock clock;
  const Result<PerSide<OpenCamera>> cameras = camera_supply(*config, setup->target, clock);
  if (!cameras) return report(cameras.error());
  fmt::print("{}: valid; setup {}, {}\n", config_file.string(), setup_text(setup->constants.identity.setup),
             setup->calibration ? "calibrated" : "no calibration: nothing will be measured");
  return number(ExitCode::kWell);
}

}  // namespace tripoint
