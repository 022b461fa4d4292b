#include "usbip.h"

#include <cstddef>

namespace tripoint::uvc {
namespace {

constexpr std::uint32_t kCommandSubmit = 1;
constexpr std::uint32_t kCommandUnlink = 2;
constexpr std::uint32_t kAnswerSubmit = 3;
constexpr std::uint32_t kAnswerUnlink = 4;
constexpr std::size_t kHeaderBytes = 48;
constexpr std::size_t kIsoPacketBytes = 16;
constexpr std::uint32_t kPacketsMax = 1024;     // vhci_hcd's own limit (USBIP_MAX_ISO_PACKETS)
constexpr std::uint32_t kSentBytesMax = 65536;  // far above any control request of a camera

// Offsets in the header: a basic part of five words, then what the command means by the rest.
constexpr std::size_t kAtCommand = 0, kAtSequence = 4, kAtDirection = 12, kAtEndpoint = 16;
constexpr std::size_t kAtLength = 24, kAtPackets = 32, kAtSetup = 40;
constexpr std::size_t kAtVictim = 20;

std::uint32_t big_u32(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
         bytes[at + 3];
}

std::uint16_t little_u16(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

void append_big_u32(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

Setup setup_from(std::span<const std::uint8_t> bytes) {
  return {bytes[0], bytes[1], little_u16(bytes, 2), little_u16(bytes, 4), little_u16(bytes, 6)};
}

std::optional<std::vector<IsoPacket>> read_packets(const Socket& connection, std::uint32_t count) {
  Bytes bytes(count * kIsoPacketBytes);
  if (!connection.read_exactly(bytes)) return std::nullopt;
  std::vector<IsoPacket> packets;
  packets.reserve(count);
  for (std::size_t at = 0; at < bytes.size(); at += kIsoPacketBytes) {
    packets.push_back({big_u32(bytes, at), big_u32(bytes, at + 4)});
  }
  return packets;
}

std::optional<Request> read_submit(const Socket& connection, std::span<const std::uint8_t> header) {
  Submit submit{
      big_u32(header, kAtSequence), big_u32(header, kAtEndpoint), setup_from(header.subspan(kAtSetup)), {}, {}};
  const bool sends = big_u32(header, kAtDirection) == 0;
  const std::uint32_t length = big_u32(header, kAtLength);
  if (sends) {
    if (length > kSentBytesMax) return std::nullopt;
    submit.sent.resize(length);
    if (!connection.read_exactly(submit.sent)) return std::nullopt;
  }
  // A transfer that is not isochronous has 0 or 0xFFFFFFFF here, depending on the kernel.
  const std::uint32_t packets = big_u32(header, kAtPackets);
  if (submit.endpoint != 0 && packets <= kPacketsMax) {
    const auto read = read_packets(connection, packets);
    if (!read) return std::nullopt;
    submit.packets = *read;
  }
  return submit;
}

Bytes answer_header(std::uint32_t command, std::uint32_t sequence, Status status, std::size_t actual,
                    std::size_t packets) {
  Bytes bytes;
  bytes.reserve(kHeaderBytes + actual + packets * kIsoPacketBytes);
  append_big_u32(bytes, command);
  append_big_u32(bytes, sequence);
  bytes.resize(kAtVictim);  // device, direction and endpoint are 0 in an answer
  append_big_u32(bytes, static_cast<std::uint32_t>(status));
  append_big_u32(bytes, static_cast<std::uint32_t>(actual));
  append_big_u32(bytes, 0);  // start frame
  append_big_u32(bytes, static_cast<std::uint32_t>(packets));
  bytes.resize(kHeaderBytes);
  return bytes;
}

}  // namespace

std::optional<Request> read_request(const Socket& connection) {
  std::array<std::uint8_t, kHeaderBytes> header{};
  if (!connection.read_exactly(header)) return std::nullopt;
  switch (big_u32(header, kAtCommand)) {
    case kCommandSubmit:
      return read_submit(connection, header);
    case kCommandUnlink:
      return Unlink{big_u32(header, kAtSequence), big_u32(header, kAtVictim)};
    default:
      return std::nullopt;
  }
}

Bytes answer_to_control(const Submit& submit, Status status, std::span<const std::uint8_t> data) {
  const bool sent_by_host = !submit.sent.empty();
  const std::size_t actual = sent_by_host ? submit.sent.size() : data.size();
  Bytes bytes = answer_header(kAnswerSubmit, submit.sequence, status, status == Status::kDone ? actual : 0, 0);
  if (!sent_by_host) bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

Bytes answer_to_unlink(const Unlink& unlink, Status status) {
  return answer_header(kAnswerUnlink, unlink.sequence, status, 0, 0);
}

Bytes answer_to_iso(const Submit& submit, std::span<const std::uint8_t> payloads,
                    std::span<const std::uint32_t> lengths) {
  Bytes bytes = answer_header(kAnswerSubmit, submit.sequence, Status::kDone, payloads.size(), submit.packets.size());
  bytes.insert(bytes.end(), payloads.begin(), payloads.end());
  for (std::size_t i = 0; i < submit.packets.size(); ++i) {
    append_big_u32(bytes, submit.packets[i].offset);
    append_big_u32(bytes, submit.packets[i].length);
    append_big_u32(bytes, lengths[i]);
    append_big_u32(bytes, static_cast<std::uint32_t>(Status::kDone));
  }
  return bytes;
}

}  // namespace tripoint::uvc
