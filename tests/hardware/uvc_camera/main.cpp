// Two simulated webcams for the virtual machine: `uvc_camera YUYV_RECORDING MJPEG_RECORDING`.
//
// Prints one line, {"left": PORT, "right": PORT, "control": PORT}, all on 127.0.0.1. A connection to the first two is
// handed to vhci_hcd; a connection to the third gives one line each way:
//   unplug SIDE | hang SIDE | resume SIDE  ->  "done" or "refused"
//   show FIRST COUNT                       ->  the same; pictures in turn, each with noise of its own
//   freeze FIRST COUNT                     ->  the same; byte for byte, as stale buffers would come
//   settings SIDE                          ->  what the camera holds
// Ends with its parent or on SIGTERM.
#include <sys/prctl.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <thread>

#include "camera.h"
#include "pictures.h"
#include "socket.h"

namespace {

using namespace std::chrono_literals;
using tripoint::uvc::Camera;
using tripoint::uvc::Playlist;
using tripoint::uvc::Socket;

std::string line_from(const Socket& connection) {
  constexpr std::size_t kLongest = 100;
  std::string line;
  std::uint8_t letter = 0;
  while (line.size() < kLongest && connection.readable_within(2s) && connection.read_exactly({&letter, 1}) &&
         letter != '\n') {
    line += static_cast<char>(letter);
  }
  return line;
}

std::string outcome_of(const std::string& order, Camera& left, Camera& right, Playlist& playlist) {
  std::istringstream words(order);
  std::string verb;
  words >> verb;
  if (verb == "show" || verb == "freeze") {
    std::size_t first = 0;
    std::size_t count = 0;
    words >> first >> count;
    return words && playlist.show(first, count, verb == "show") ? "done" : "refused";
  }
  std::string side;
  words >> side;
  if (side != "left" && side != "right") return "refused";
  Camera& camera = side == "left" ? left : right;
  if (verb == "settings") return camera.settings();
  if (verb == "unplug")
    camera.unplug();
  else if (verb == "hang")
    camera.hang(true);
  else if (verb == "resume")
    camera.hang(false);
  else
    return "refused";
  return "done";
}

[[noreturn]] void take_orders(const Socket& control, Camera& left, Camera& right, Playlist& playlist) {
  for (;;) {
    const auto connection = control.accepted_within(1s);
    if (!connection) continue;
    const std::string outcome = outcome_of(line_from(*connection), left, right, playlist) + '\n';
    static_cast<void>(connection->write_all({reinterpret_cast<const std::uint8_t*>(outcome.data()), outcome.size()}));
  }
}

void serve(const tripoint::uvc::RecordingFolders& folders) {
  auto left_pictures = tripoint::uvc::pictures_from(folders, "left");
  auto right_pictures = tripoint::uvc::pictures_from(folders, "right");
  Playlist playlist(std::min(left_pictures.yuyv.size(), right_pictures.yuyv.size()));
  const auto epoch = std::chrono::steady_clock::now();
  Camera left("LEFT-001", std::move(left_pictures), playlist, epoch);
  Camera right("RIGHT-001", std::move(right_pictures), playlist, epoch);
  const Socket left_port = Socket::listening();
  const Socket right_port = Socket::listening();
  const Socket control = Socket::listening();
  const std::jthread left_thread([&](const std::stop_token& stop) { left.run(left_port, stop); });
  const std::jthread right_thread([&](const std::stop_token& stop) { right.run(right_port, stop); });
  std::printf("{\"left\": %d, \"right\": %d, \"control\": %d}\n", left_port.port(), right_port.port(), control.port());
  std::fflush(stdout);
  take_orders(control, left, right, playlist);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: uvc_camera YUYV_RECORDING MJPEG_RECORDING\n");
    return 2;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  try {
    serve({arguments[1], arguments[2]});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "uvc_camera: %s\n", error.what());
    return 1;
  }
}
