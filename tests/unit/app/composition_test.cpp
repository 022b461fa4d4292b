// The whole unit with all its threads on simulated cameras; what each part does is tested in its room.
#include "app/composition.h"
#include "contract/registers.h"
#include "places.h"
#include "scratch_folder.h"
#include "sim/rendered_recording.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

namespace tripoint {
namespace {

constexpr auto kPatience = std::chrono::seconds(60);  // far beyond what a sanitizer on a busy machine needs

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A TCP socket that closes itself.
class Socket {
 public:
  Socket() : fd_(::socket(AF_INET, SOCK_STREAM, 0)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() { ::close(fd_); }

  [[nodiscard]] int fd() const { return fd_; }
  bool connect(std::uint16_t port) const {
    const sockaddr_in address = loopback(port);
    return ::connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  std::uint16_t listen() const {
    sockaddr_in address = loopback(0);
    ::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(fd_, 1);
    socklen_t length = sizeof address;
    ::getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &length);
    return ntohs(address.sin_port);
  }

 private:
  int fd_;
};

struct Read {
  std::uint16_t heartbeat = 0;
  std::uint16_t status = 0;
  std::uint16_t state = 0;

  [[nodiscard]] bool valid() const { return (status & 0x0004U) != 0; }
};

/// Registers 32 to 36 by FC 4.
std::optional<Read> state_block(std::uint16_t port) {
  const Socket socket;
  if (!socket.connect(port)) return std::nullopt;
  const std::array<std::uint8_t, 12> request{0, 1, 0, 0, 0, 6, 1, 4, 0, 32, 0, 5};
  std::array<std::uint8_t, 19> answer{};
  if (::send(socket.fd(), request.data(), request.size(), 0) != static_cast<ssize_t>(request.size())) return {};
  if (::recv(socket.fd(), answer.data(), answer.size(), MSG_WAITALL) != static_cast<ssize_t>(answer.size())) return {};
  const auto word = [&](std::size_t at) { return static_cast<std::uint16_t>(answer[at] << 8U | answer[at + 1]); };
  return Read{word(9), word(11), word(17)};
}

constexpr ImageSize kSize{320, 240};

Config demo_config(std::uint16_t port) {
  Config config = load_config(test::top_folder() / "deploy/demo/demo.toml", {}).value();
  config.modbus.port = port;
  config.target_file.clear();  // one LED
  config.cameras.size = kSize;
  config.calibration_file = test::top_folder() / "tests/unit/app/small_rig.toml";
  // A sanitizer on a busy machine renders late all the same.
  config.cameras.loss_after = std::chrono::seconds(5);
  config.output.age_limit = std::chrono::seconds(5);
  return config;
}

std::uint16_t free_port() {
  const Socket probe;
  return probe.listen();
}

constexpr double kRecordedRate_hz = 15.0;

/// Three seconds of what the demo's cameras see.
void record_demo(const std::filesystem::path& folder) {
  SimulationSettings settings;
  settings.rig = default_rig(kSize);
  settings.format = PixelFormat::kMjpeg;
  settings.rate_hz = kRecordedRate_hz;
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  EXPECT_TRUE(write_rendered_recording(world, static_cast<int>(3.0 * kRecordedRate_hz), folder));
}

/// Waits for an answer that is as it should be.
bool becomes(std::uint16_t port, const std::function<bool(const Read&)>& right) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    const auto read = state_block(port);
    if (read && right(*read)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

bool becomes_valid(std::uint16_t port) {
  return becomes(port, [](const Read& read) { return read.heartbeat > 0 && read.valid(); });
}

TEST(CompositionTest, TheWholeUnitMeasuresAndAnswers) {
  const std::uint16_t port = free_port();
  bool valid = false;
  const Result<void> ran = run_unit(demo_config(port), [&] { valid = becomes_valid(port); });
  EXPECT_TRUE(ran);
  EXPECT_TRUE(valid);
}

// That the LED is believed needs pictures in time: tests/system/test_modulation.py. Here ThreadSanitizer watches what
// the switching thread and the cameras' threads share.
TEST(CompositionTest, AModulatedUnitSwitchesMeasuresAndAnswersAtTheSameTime) {
  const std::uint16_t port = free_port();
  Config config = demo_config(port);
  config.modulation.enabled = true;
  bool went_on = false;
  const Result<void> ran =
      run_unit(config, [&] { went_on = becomes(port, [](const Read& read) { return read.heartbeat >= 40; }); });
  EXPECT_TRUE(ran);
  EXPECT_TRUE(went_on);
}

TEST(CompositionTest, ARecordingIsMeasuredWhileItPlays) {
  const std::uint16_t port = free_port();
  Config config = demo_config(port);
  config.cameras.source = CameraSource::kRecording;
  config.cameras.rate_hz = kRecordedRate_hz;
  const test::ScratchFolder folder;
  record_demo(folder.path());
  config.recording.folder = folder.path();
  bool valid = false;
  const Result<void> ran = run_unit(config, [&] { valid = becomes_valid(port); });
  EXPECT_TRUE(ran);
  EXPECT_TRUE(valid);
}

TEST(CompositionTest, AUnitThatStopsSaysSoWithoutAValidPoseBeforeItsPortCloses) {
  const std::uint16_t port = free_port();
  Read last;
  std::jthread client;
  const Result<void> ran = run_unit(demo_config(port), [&] {
    EXPECT_TRUE(becomes_valid(port));
    client = std::jthread([&] {
      while (const auto read = state_block(port)) last = *read;
    });
  });
  client.join();
  EXPECT_TRUE(ran);
  EXPECT_EQ(last.state, 6);
  EXPECT_FALSE(last.valid());
}

TEST(CompositionTest, TheConfigurationsDefaultIsTheDocumentedNumberOfConnections) {
  EXPECT_EQ(static_cast<std::uint32_t>(ModbusConfig{}.max_connections), registers::server::kMostConnections);
}

TEST(CompositionTest, APortInUseIsAnErrorBeforeAnythingRuns) {
  const Socket taken;
  const std::uint16_t port = taken.listen();
  bool ran = false;
  const Result<void> result = run_unit(demo_config(port), [&] { ran = true; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kAddressInUse);
  EXPECT_FALSE(ran);
}

}  // namespace
}  // namespace tripoint
