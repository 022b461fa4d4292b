#include "net/modbus_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "client.h"
#include "serve/states.h"
#include "served.h"

namespace tripoint {
namespace {

using namespace tripoint::test;
using testing::ElementsAre;

TEST(ModbusServerTest, AnswersWithTheTransactionAndUnitItWasAsked) {
  Served served;
  const Client client(served.server.port());
  EXPECT_THAT(client.ask(frame_of(0xABCD, {3, 0, 0, 0, 1}), 11),
              ElementsAre(0xAB, 0xCD, 0, 0, 0, 5, 255, 3, 2, 0x54, 0x50));
}

TEST(ModbusServerTest, APoseThatNobodyReplacesIsStaleOnceTheAnswerIsMadePastTheAgeLimit) {
  std::atomic<TimePoint> now = kExposed + OutputLimits{}.age_limit;
  Served served(any_port(), [&now] { return now.load(); });
  served.publication.publish(unit_state(), kExposed);
  const Client client(served.server.port());
  const Bytes status_request = frame_of(1, {3, 0, 101, 0, 1});
  const Bytes x_request = frame_of(2, {3, 0, 110, 0, 2});
  constexpr unsigned kValidAndStale = 0x0014;  // bits 2 and 4
  EXPECT_EQ(client.ask(status_request, 11).back() & kValidAndStale, 0x04U);
  EXPECT_THAT(client.ask(x_request, 13), ElementsAre(0, 2, 0, 0, 0, 7, 255, 3, 4, 0xFF, 0xFF, 0xB7, 0x12));  // -18 670

  now = now.load() + Duration{1};
  EXPECT_EQ(client.ask(status_request, 11).back() & kValidAndStale, 0x10U);
  EXPECT_THAT(client.ask(x_request, 13), ElementsAre(0, 2, 0, 0, 0, 7, 255, 3, 4, 0x80, 0, 0, 0));
}

TEST(ModbusServerTest, TellsHowManyClientsAreConnected) {
  Served served;
  const Client first(served.server.port());
  const Client second(served.server.port());
  ASSERT_TRUE(first.is_served() && second.is_served());
  EXPECT_THAT(second.ask(frame_of(1, {4, 0, 37, 0, 1}), 11).back(), 2);
}

TEST(ModbusServerTest, APortInUseIsNamed) {
  Served served;
  ModbusSettings settings = any_port();
  settings.port = served.server.port();
  const auto second = ModbusServer::open(settings, served.responder, monotonic_now, quiet);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kAddressInUse);
  EXPECT_THAT(second.error().message, testing::HasSubstr(std::to_string(settings.port)));
}

TEST(ModbusServerTest, AnAddressOfAnotherMachineIsRefused) {
  Served served;
  ModbusSettings settings = any_port();
  for (const char* address : {"192.0.2.1", "nonsense"}) {
    settings.address = address;
    const auto refused = ModbusServer::open(settings, served.responder, monotonic_now, quiet);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange) << address;
  }
}

TEST(ModbusServerTest, StopsWhenAskedTo) {
  auto served = std::make_unique<Served>();
  const Client client(served->server.port());
  ASSERT_TRUE(client.is_served());
  served.reset();  // joins the thread
  EXPECT_TRUE(client.is_closed());
}

TEST(ModbusServerTest, PipelinedRequestsAreAnsweredInOrder) {
  Served served;
  const Client client(served.server.port());
  constexpr std::uint16_t kRequests = 50;  // more than one turn
  Bytes all;
  for (std::uint16_t i = 0; i < kRequests; ++i) {
    const Bytes one = frame_of(i, {3, 0, 0, 0, 1});
    all.insert(all.end(), one.begin(), one.end());
  }
  const Bytes answers = client.ask(all, std::size_t{11} * kRequests);
  ASSERT_EQ(answers.size(), std::size_t{11} * kRequests);
  for (std::size_t i = 0; i < kRequests; ++i) EXPECT_EQ(answers[11 * i + 1], i);
}

TEST(ModbusServerTest, ARequestMayComeByteByByte) {
  Served served;
  const Client client(served.server.port());
  for (const std::uint8_t byte : pose_request()) client.send(std::span(&byte, 1));
  EXPECT_EQ(client.receive(kPoseAnswerBytes).size(), kPoseAnswerBytes);
}

TEST(ModbusServerTest, OnlyNamedClientsCommand) {
  ModbusSettings settings = any_port();
  settings.command_clients = {client_network_from("127.0.0.2").value()};
  Served served(settings);
  const Bytes write = frame_of(1, {6, 3, 0xE8, 0, 0});
  EXPECT_EQ(Client(served.server.port(), "127.0.0.1").ask(write, 9)[7], 0x86);
  EXPECT_EQ(Client(served.server.port(), "127.0.0.2").ask(write, 12)[7], 6);
}

TEST(ModbusServerTest, ClientsOffTheAllowListAreRefusedAndCounted) {
  ModbusSettings settings = any_port();
  settings.allowed_clients = {client_network_from("127.0.0.2/32").value()};
  Served served(settings);
  EXPECT_TRUE(Client(served.server.port(), "127.0.0.1").is_closed());
  EXPECT_TRUE(Client(served.server.port(), "127.0.0.2").is_served());
  EXPECT_EQ(served.server.counters().refused, 1U);
}

TEST(ModbusServerTest, ARefusalIsAWarningForEveryOtherClientForTenSeconds) {
  ModbusSettings settings = any_port();
  settings.most_connections = 1;
  std::atomic<int> passed_s = 0;
  Served served(settings, [&] { return monotonic_now() + std::chrono::seconds(passed_s); });
  const Client client(served.server.port());
  const auto warnings = [&] { return client.ask(frame_of(1, {3, 0, 35, 0, 1}), 11)[9]; };
  EXPECT_EQ(warnings(), 0);
  EXPECT_TRUE(Client(served.server.port()).is_closed());
  EXPECT_EQ(warnings(), 2);  // bit 9
  passed_s = 10;
  EXPECT_EQ(warnings(), 0);
}

TEST(ModbusServerTest, ARefusalIsSaidInTheLog) {
  ModbusSettings settings = any_port();
  settings.most_connections = 1;
  std::mutex mutex;
  std::vector<std::string> said;
  Served served(settings, monotonic_now, [&](std::string_view what) {
    const std::scoped_lock lock(mutex);
    said.emplace_back(what);
  });
  const auto lines = [&] {
    const std::scoped_lock lock(mutex);
    return said;
  };
  const Client client(served.server.port());
  ASSERT_TRUE(client.is_served());
  EXPECT_TRUE(Client(served.server.port()).is_closed());
  ASSERT_TRUE(served.eventually([&](const ModbusCounters&) { return !lines().empty(); }));
  EXPECT_THAT(lines().front(), testing::HasSubstr("1 connected; since the start 1 refused"));
}

TEST(ModbusServerTest, WhenFullAnotherAddressTakesThePlaceOfTheLongestSilent) {
  ModbusSettings settings = any_port();
  settings.most_connections = 3;
  Served served(settings);
  const Client silent(served.server.port());
  ASSERT_TRUE(silent.is_served());
  const Client second(served.server.port());
  const Client third(served.server.port());
  ASSERT_TRUE(second.is_served() && third.is_served());
  EXPECT_TRUE(Client(served.server.port()).is_closed());
  EXPECT_TRUE(Client(served.server.port(), "127.0.0.2").is_served());
  EXPECT_TRUE(silent.is_closed());
  EXPECT_TRUE(second.is_served() && third.is_served());
  EXPECT_EQ(served.server.counters().refused, 1U);
  EXPECT_EQ(served.server.counters().displaced, 1U);
}

}  // namespace
}  // namespace tripoint
