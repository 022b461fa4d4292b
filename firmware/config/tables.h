// One function for each table of the configuration.
#pragma once

#include <filesystem>
#include <optional>

#include "config/config.h"
#include "document/table_reader.h"

namespace tripoint {

CamerasConfig cameras_from(TableReader table);
DetectorConfig detector_from(TableReader table);
VolumeConfig volume_from(TableReader table);
TimingConfig timing_from(TableReader table);
OutputConfig output_from(TableReader table);
/// With the tables that it has to fit to: cameras and detector.
ModulationConfig modulation_from(TableReader table, const Config& config);
/// Absent unless the table is there; with the tables that it has to fit to: detector and modulation.
std::optional<DatumConfig> datum_from(TableReader& root, const Config& config);
ModbusConfig modbus_from(TableReader table);
SimulationConfig simulation_from(TableReader table, const std::filesystem::path& folder);
RecordingConfig recording_from(TableReader table, const std::filesystem::path& folder, CameraSource source);

/// A path as written, taken from `folder` when it is relative; "" stays empty.
std::filesystem::path path_from(const std::filesystem::path& folder, const std::string& written);

}  // namespace tripoint
