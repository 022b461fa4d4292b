#include <algorithm>

#include "config/address.h"
#include "config/tables.h"

namespace tripoint {
namespace {

std::vector<std::string> clients_from(TableReader& table, std::string_view key) {
  std::vector<std::string> clients = table.texts(key);
  if (!std::all_of(clients.begin(), clients.end(), is_address_or_network)) {
    table.refuse(key, R"(permitted is a list of numeric addresses or networks, as ["192.168.0.10", "192.168.1.0/24"])");
  }
  return clients;
}

}  // namespace

VolumeConfig volume_from(TableReader table) {
  constexpr Permitted<double> kPlaceMm{-100'000.0, 100'000.0};
  const VolumeConfig volume{table.vec3("min_mm", kPlaceMm), table.vec3("max_mm", kPlaceMm)};
  if (!(volume.min_mm.array() < volume.max_mm.array()).all()) {
    table.refuse("max_mm", "permitted is more than min_mm on each axis");
  }
  table.finish();
  return volume;
}

/// Of `uncertainty_mm`: the alarm begins beyond 5.7 standard deviations, of which that is two.
constexpr double kLeastRadius = 6.0 * (1.0 - 1e-9);  // 0.2 six times is no more than 1.2

std::optional<DatumConfig> datum_from(TableReader& root, const Config& config) {
  const bool given = root.has("datum");
  TableReader table = root.table("datum");
  if (!given) return std::nullopt;
  DatumConfig datum;
  datum.position_mm = table.vec3("position_mm", {-100'000.0, 100'000.0});
  datum.uncertainty_mm = table.number("uncertainty_mm", {0.001, 100.0});
  datum.radius_mm = table.number("radius_mm", {0.1, 1000.0});
  if (datum.radius_mm < kLeastRadius * datum.uncertainty_mm) {
    table.refuse("radius_mm",
                 "permitted is six times uncertainty_mm and more: a knock is noticed from half of that on, and "
                 "only within the radius");
  }
  if (config.detector.kind != ConfiguredDetector::kLed) {
    table.refuse("position_mm",
                 "a datum is an LED, which detector.kind does not find: permitted is [datum] with \"led\"");
  }
  if (config.modulation.enabled) {
    table.refuse("position_mm",
                 "a datum is lit all the time, and modulation leaves such lights out: permitted is [datum] with "
                 "modulation.enabled = false");
  }
  table.finish();
  return datum;
}

TimingConfig timing_from(TableReader table) {
  TimingConfig t;
  t.offset_prior_ms = table.number("offset_prior_ms", {0.001, 1000.0}, t.offset_prior_ms);
  t.bound_mm = table.number("bound_mm", {0.001, 1000.0}, t.bound_mm);
  t.line_time_us = table.number("line_time_us", {0.0, 1000.0}, t.line_time_us);
  table.finish();
  return t;
}

OutputConfig output_from(TableReader table) {
  OutputConfig o;
  o.frame = table.choice<ConfiguredFrame>(
      "frame", {{"reference", ConfiguredFrame::kReference}, {"left_camera", ConfiguredFrame::kLeftCamera}}, o.frame);
  o.method = table.choice<ConfiguredMethod>(
      "method", {{"maximum_likelihood", ConfiguredMethod::kMaximumLikelihood}, {"paper", ConfiguredMethod::kPaper}},
      o.method);
  o.age_limit = std::chrono::milliseconds{table.integer("age_limit_ms", {10, 10'000}, o.age_limit.count())};
  o.latch_hold = std::chrono::milliseconds{table.integer("latch_hold_ms", {100, 600'000}, o.latch_hold.count())};
  o.settled_mm_per_s = table.number("settled_mm_per_s", {0.001, 10'000.0}, o.settled_mm_per_s);
  table.finish();
  return o;
}

ModbusConfig modbus_from(TableReader table) {
  ModbusConfig m;
  m.address = table.text("address", m.address);
  if (!is_address(m.address)) {
    table.refuse("address", R"(permitted is a numeric address, as "127.0.0.1" or "0.0.0.0")");
  }
  m.port = static_cast<std::uint16_t>(table.integer("port", {1, 65'535}, m.port));
  m.command_clients = clients_from(table, "command_clients");
  m.allowed_clients = clients_from(table, "allowed_clients");
  m.max_connections = static_cast<int>(table.integer("max_connections", {1, 1000}, m.max_connections));
  m.serial_number = static_cast<std::uint32_t>(table.integer("serial_number", {0, 4'294'967'295}, m.serial_number));
  table.finish();
  return m;
}

}  // namespace tripoint
