#include "descriptors.h"

namespace tripoint::uvc {
namespace {

constexpr std::uint8_t kDevice = 1, kConfiguration = 2, kString = 3, kInterface = 4, kEndpoint = 5, kQualifier = 6;
constexpr std::uint8_t kAssociation = 11;
constexpr std::uint8_t kVideoInterface = 0x24;  // CS_INTERFACE
constexpr std::uint8_t kVideoClass = 14, kControlSubclass = 1, kStreamingSubclass = 2, kCollectionSubclass = 3;
constexpr std::uint8_t kControlHeader = 1, kInputTerminal = 2, kOutputTerminal = 3, kUnit = 5;
constexpr std::uint8_t kInputHeader = 1, kFormatUncompressed = 4, kFrameUncompressed = 5, kFormatMjpeg = 6,
                       kFrameMjpeg = 7, kColorMatching = 13;
constexpr std::uint8_t kUsbOutput = 3;  // terminal that stands for the host
constexpr std::uint8_t kStreamEndpoint = 0x81;
constexpr std::uint16_t kUsbVersion = 0x0200, kVideoVersion = 0x0110;
constexpr std::uint16_t kVendorLinuxFoundation = 0x1d6b, kProductWebcam = 0x0102;
// bmControls: D1 exposure mode, D2 exposure priority, D3 exposure time, D5 focus, D17 automatic focus.
constexpr std::uint32_t kCameraControls = 1U << 1 | 1U << 2 | 1U << 3 | 1U << 5 | 1U << 17;
// bmControls: D0 brightness, D6 white balance, D9 gain, D10 power line frequency, D12 automatic white balance.
constexpr std::uint16_t kProcessingControls = 1U << 0 | 1U << 6 | 1U << 9 | 1U << 10 | 1U << 12;

/// One descriptor under construction: little-endian fields behind its length and type.
class Descriptor {
 public:
  explicit Descriptor(std::uint8_t type) : bytes_{0, type} {}

  Descriptor& u8(std::initializer_list<std::uint8_t> values) {
    bytes_.insert(bytes_.end(), values);
    return *this;
  }
  Descriptor& u16(std::uint16_t value) {
    return u8({static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8)});
  }
  Descriptor& u32(std::uint32_t value) {
    return u16(static_cast<std::uint16_t>(value)).u16(static_cast<std::uint16_t>(value >> 16));
  }
  [[nodiscard]] Bytes whole() const {
    Bytes bytes = bytes_;
    bytes[0] = static_cast<std::uint8_t>(bytes.size());
    return bytes;
  }

 private:
  Bytes bytes_;
};

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Bytes interface_descriptor(std::uint8_t number, std::uint8_t alternate, std::uint8_t endpoints, std::uint8_t subclass) {
  return Descriptor(kInterface).u8({number, alternate, endpoints, kVideoClass, subclass, 0, 0}).whole();
}

/// Camera terminal -> processing unit -> USB.
Bytes control_interface() {
  const Bytes camera = Descriptor(kVideoInterface)
                           .u8({kInputTerminal, kCameraTerminal})
                           .u16(0x0201)  // a camera
                           .u8({0, 0})
                           .u16(0)
                           .u16(0)
                           .u16(0)  // no zoom lens
                           .u8({3, kCameraControls & 0xff, kCameraControls >> 8 & 0xff, kCameraControls >> 16 & 0xff})
                           .whole();
  const Bytes unit = Descriptor(kVideoInterface)
                         .u8({kUnit, kProcessingUnit, kCameraTerminal})
                         .u16(0)
                         .u8({2})
                         .u16(kProcessingControls)
                         .u8({0, 0})
                         .whole();
  const Bytes output = Descriptor(kVideoInterface)
                           .u8({kOutputTerminal, kUsbOutput})
                           .u16(0x0101)  // USB streaming
                           .u8({0, kProcessingUnit, 0})
                           .whole();
  constexpr std::size_t kHeaderBytes = 13;
  const Bytes header = Descriptor(kVideoInterface)
                           .u8({kControlHeader})
                           .u16(kVideoVersion)
                           .u16(static_cast<std::uint16_t>(kHeaderBytes + camera.size() + unit.size() + output.size()))
                           .u32(kClockHz)
                           .u8({1, kStreamingInterface})
                           .whole();
  return joined({interface_descriptor(kControlInterface, 0, 0, kControlSubclass), header, camera, unit, output});
}

Bytes frame_descriptor(std::uint8_t subtype) {
  constexpr std::uint32_t kBitsPerFrame = kYuyvBytes * 8;
  Descriptor frame(kVideoInterface);
  frame.u8({subtype, 1, 0}).u16(kWidthPx).u16(kHeightPx).u32(kBitsPerFrame * 5).u32(kBitsPerFrame * 30);
  frame.u32(kYuyvBytes).u32(kIntervals.front()).u8({static_cast<std::uint8_t>(kIntervals.size())});
  for (const std::uint32_t interval : kIntervals) frame.u32(interval);
  return frame.whole();
}

Bytes formats() {
  // GUID of YUY2: 32595559-0000-0010-8000-00AA00389B71.
  const Bytes yuyv = Descriptor(kVideoInterface)
                         .u8({kFormatUncompressed, static_cast<std::uint8_t>(Format::kYuyv), 1})
                         .u8({'Y', 'U', 'Y', '2', 0, 0, 0x10, 0, 0x80, 0, 0, 0xaa, 0, 0x38, 0x9b, 0x71})
                         .u8({16, 1, 0, 0, 0, 0})  // 16 bits per pixel
                         .whole();
  const Bytes mjpeg = Descriptor(kVideoInterface)
                          .u8({kFormatMjpeg, static_cast<std::uint8_t>(Format::kMjpeg), 1, 0, 1, 0, 0, 0, 0})
                          .whole();
  const Bytes color =
      Descriptor(kVideoInterface).u8({kColorMatching, 1, 1, 4}).whole();  // BT.709 primaries, BT.601 matrix
  return joined({yuyv, frame_descriptor(kFrameUncompressed), color, mjpeg, frame_descriptor(kFrameMjpeg), color});
}

Bytes streaming_interface() {
  const Bytes described = formats();
  constexpr std::size_t kHeaderBytes = 15;
  const Bytes header = Descriptor(kVideoInterface)
                           .u8({kInputHeader, 2})
                           .u16(static_cast<std::uint16_t>(kHeaderBytes + described.size()))
                           .u8({kStreamEndpoint, 0, kUsbOutput, 0, 0, 0, 1, 0, 0})
                           .whole();
  const Bytes endpoint = Descriptor(kEndpoint)
                             .u8({kStreamEndpoint, 0x05})  // isochronous, asynchronous
                             .u16(0x1400)                  // 1024 bytes, three transactions in a microframe
                             .u8({1})
                             .whole();
  return joined({interface_descriptor(kStreamingInterface, 0, 0, kStreamingSubclass), header, described,
                 interface_descriptor(kStreamingInterface, 1, 1, kStreamingSubclass), endpoint});
}

}  // namespace

Bytes device_descriptor() {
  return Descriptor(kDevice)
      .u16(kUsbVersion)
      .u8({0xef, 2, 1, 64})  // functions are joined by an association; 64 bytes on endpoint 0
      .u16(kVendorLinuxFoundation)
      .u16(kProductWebcam)
      .u16(0x0100)
      .u8({1, 2, 3, 1})  // strings: manufacturer, product, serial; one configuration
      .whole();
}

Bytes device_qualifier() { return Descriptor(kQualifier).u16(kUsbVersion).u8({0xef, 2, 1, 64, 1, 0}).whole(); }

Bytes configuration_descriptor() {
  const Bytes association =
      Descriptor(kAssociation).u8({kControlInterface, 2, kVideoClass, kCollectionSubclass, 0, 0}).whole();
  const Bytes interfaces = joined({association, control_interface(), streaming_interface()});
  constexpr std::size_t kHeaderBytes = 9;
  const Bytes header = Descriptor(kConfiguration)
                           .u16(static_cast<std::uint16_t>(kHeaderBytes + interfaces.size()))
                           .u8({2, 1, 0, 0x80, 250})  // two interfaces, fed by the bus with 500 mA
                           .whole();
  return joined({header, interfaces});
}

Bytes string_descriptor(std::uint8_t index, std::string_view serial) {
  if (index == 0) return Descriptor(kString).u16(0x0409).whole();  // English
  const std::array<std::string_view, 3> texts{"Tripoint simulation", "Simulated UVC camera", serial};
  if (index > texts.size()) return {};
  Descriptor text(kString);
  for (const char letter : texts[index - 1U]) text.u16(static_cast<std::uint8_t>(letter));
  return text.whole();
}

}  // namespace tripoint::uvc
