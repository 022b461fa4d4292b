#include "app/composition.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "app/camera_supply.h"
#include "app/detection.h"
#include "app/measuring.h"
#include "app/modulation_wiring.h"
#include "app/unit_setup.h"
#include "app/version.h"
#include "capture/camera_worker.h"
#include "devices/realtime.h"
#include "devices/system_clock.h"
#include "net/modbus_server.h"
#include "serve/publication.h"
#include "serve/responder.h"

namespace tripoint {
namespace {

constexpr std::size_t kQueuedEvents = 16;                   // a quarter of a second of both cameras
constexpr int kModbusPriority = 50;                         // below the kernel's own interrupt threads
constexpr int kMeasuringPriority = 49;                      // clients read even while the line works
constexpr auto kFarewell = std::chrono::milliseconds(250);  // two polls of the slowest client that registers.md names

Result<ModbusSettings> modbus_settings(const ModbusConfig& config) {
  ModbusSettings settings;
  settings.address = config.address;
  settings.port = config.port;
  settings.most_connections = static_cast<std::size_t>(config.max_connections);
  for (const std::string& client : config.allowed_clients) {
    const Result<ClientNetwork> network = client_network_from(client);
    if (!network) return tl::make_unexpected(network.error());
    settings.allowed_clients.push_back(*network);
  }
  for (const std::string& client : config.command_clients) {
    const Result<ClientNetwork> network = client_network_from(client);
    if (!network) return tl::make_unexpected(network.error());
    settings.command_clients.push_back(*network);
  }
  return settings;
}

/// Where it is not permitted the thread runs on as it is, and the log says so.
void ask_for_priority(std::string_view thread, int priority) {
  if (const Result<void> granted = take_realtime_priority(priority); !granted) {
    spdlog::info("{}: {}", thread, granted.error().message);
  }
}

void serve_modbus(ModbusServer& server, const std::stop_token& stop) {
  ask_for_priority("modbus", kModbusPriority);
  server.run(stop);
}

void measure(Measuring& measuring, const std::stop_token& stop) {
  ask_for_priority("measuring", kMeasuringPriority);
  measuring.run(stop);
}

/// Everything that the threads share; it outlives them.
struct Unit {
  SystemClock clock;
  BoundedQueue<Event> events{kQueuedEvents};
  PerSide<Latest<CameraStatus>> cameras;
  Latest<Forecast> forecast;
  Publication publication;
  Responder responder;

  explicit Unit(UnitState first) : publication(std::move(first)), responder(publication, device_identification()) {}
};

CameraWorker camera_worker(Unit& unit, Side side, const Config& config, CameraTasks tasks) {
  CameraLimits limits;
  limits.frame = config.cameras.loss_after;
  tasks.whole_pictures = needs_whole_pictures(config.detector);
  return {
      side, std::move(tasks),
      CameraLinks{.events = unit.events, .forecast = unit.forecast, .status = unit.cameras[side], .clock = unit.clock},
      limits};
}

}  // namespace

Result<void> run_unit(const Config& config, const std::function<void()>& until_stop) {
  Result<UnitSetup> setup = unit_setup(config);
  if (!setup) return tl::make_unexpected(setup.error());
  const Result<ModbusSettings> settings = modbus_settings(config.modbus);
  if (!settings) return tl::make_unexpected(settings.error());

  const SystemClock started_by;
  UnitReport report(setup->constants, started_by.now());
  Unit unit(report.state({}, started_by));
  std::optional<ModulationWiring> modulation;
  if (config.modulation.enabled) modulation.emplace(config.modulation, setup->target.target, unit.clock);
  const auto sift = [&](Side side) { return modulation ? modulation->sift(side) : SiftPoints{}; };
  Result<PerSide<OpenCamera>> cameras =
      camera_supply(config, setup->target, unit.clock, modulation ? &modulation->simulated_leds() : nullptr);
  if (!cameras) return tl::make_unexpected(cameras.error());
  Result<DetectPoints> detect_left = detection_of(config.detector, setup->target);
  Result<DetectPoints> detect_right = detection_of(config.detector, setup->target);
  if (!detect_left || !detect_right) return tl::make_unexpected((detect_left ? detect_right : detect_left).error());
  Result<ModbusServer> server = ModbusServer::open(
      *settings, unit.responder, [&unit] { return unit.clock.now(); },
      [](std::string_view what) { spdlog::warn("{}", what); });
  if (!server) return tl::make_unexpected(server.error());
  spdlog::info("modbus: {}:{}, setup {}", config.modbus.address, server->port(),
               setup_text(setup->constants.identity.setup));

  const auto worker = [&](Side side, OpenCamera& open, DetectPoints& detect) {
    return camera_worker(unit, side, config,
                         {.open = std::move(open), .detect = std::move(detect), .sift = sift(side)});
  };
  CameraWorker left = worker(Side::kLeft, cameras->left, *detect_left);
  CameraWorker right = worker(Side::kRight, cameras->right, *detect_right);
  Measuring measuring({unit.events, unit.cameras, unit.forecast, unit.publication, unit.clock}, setup->model,
                      fits_calibration(setup->calibration, config.cameras.source), std::move(report));

  std::optional<LedSwitcher> switcher;
  if (modulation) switcher.emplace(modulation->switcher());
  std::jthread switching;
  if (switcher) switching = std::jthread([&switcher](const std::stop_token& token) { switcher->run(token); });
  const std::jthread modbus([&server](const std::stop_token& token) { serve_modbus(*server, token); });
  std::jthread measuring_thread([&measuring](const std::stop_token& token) { measure(measuring, token); });
  std::jthread left_thread([&left](const std::stop_token& token) { left.run(token); });
  std::jthread right_thread([&right](const std::stop_token& token) { right.run(token); });
  until_stop();
  spdlog::info("stopping");
  for (std::jthread* const thread : {&measuring_thread, &left_thread, &right_thread}) thread->request_stop();
  measuring_thread.join();
  std::this_thread::sleep_for(kFarewell);  // so that clients read that the unit has stopped before they lose it
  return {};
}

}  // namespace tripoint
