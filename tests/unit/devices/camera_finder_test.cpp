#include "devices/camera_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>
#include <fstream>

#include "fake_v4l2_driver.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A tree as the kernel shows it: class/video4linux/videoN, whose device leads to a USB interface.
class CameraFinderTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(roots_.sys / "class/video4linux"); }

  static void write(const fs::path& file, std::string_view text) { std::ofstream(file) << text << "\n"; }

  void add_usb(int number, const std::string& port, const std::string& serial, std::string_view index = "0") const {
    const fs::path usb = roots_.sys / "devices/pci0/usb1" / port;
    const fs::path interface = usb / (port + ":1.0");
    fs::create_directories(interface);
    write(usb / "idVendor", "046d");
    write(usb / "idProduct", "0825");
    write(usb / "product", "Test camera");
    if (!serial.empty()) write(usb / "serial", serial);
    add_node(number, index, interface);
  }
  void add_node(int number, std::string_view index, const fs::path& device) const {
    const fs::path node = roots_.sys / "class/video4linux" / ("video" + std::to_string(number));
    fs::create_directories(node);
    fs::create_directory_symlink(device, node / "device");
    write(node / "index", index);
    write(node / "name", "Platform camera");
  }
  std::vector<FoundCamera> found() { return cameras(driver_, roots_); }

  test::WaitingClock clock_;
  test::FakeV4l2Driver driver_{clock_};
  test::ScratchFolder sys_;
  DeviceRoots roots_{sys_.path(), "/dev"};
};

TEST_F(CameraFinderTest, ACameraIsNamedByPortAndSerial) {
  add_usb(2, "1-1.4", "LEFT-001");
  const auto all = found();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].node, "/dev/video2");
  EXPECT_EQ(all[0].port, "1-1.4");
  EXPECT_EQ(all[0].serial, "LEFT-001");
  EXPECT_EQ(all[0].vendor, "046d");
  EXPECT_EQ(all[0].product, "Test camera");
  EXPECT_THAT(all[0].formats, ElementsAre("YUYV 640x480 at 30 Hz"));
}

TEST_F(CameraFinderTest, CamerasAreSortedByPort) {
  add_usb(0, "1-2", "B");
  add_usb(4, "1-1", "A");
  const auto all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].serial, "A");
}

TEST_F(CameraFinderTest, ACameraOffUsbHasNoPort) {
  fs::create_directories(roots_.sys / "devices/platform/csi");
  add_node(0, "0", roots_.sys / "devices/platform/csi");
  const auto all = found();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].port, "");
  EXPECT_EQ(all[0].product, "Platform camera");
}

TEST_F(CameraFinderTest, MetadataNodesAreNoCameras) {
  add_usb(1, "1-1", "A", "1");
  driver_.capabilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  EXPECT_TRUE(found().empty());
}

TEST_F(CameraFinderTest, ACameraThatCannotBeOpenedIsListedWithoutFormats) {
  add_usb(0, "1-1", "A", "0");
  add_usb(1, "1-2", "B", "1");
  driver_.open_failure = -EACCES;
  const auto all = found();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].serial, "A");
  EXPECT_TRUE(all[0].formats.empty());
}

TEST_F(CameraFinderTest, AMachineWithoutVideoHasNoCameras) {
  fs::remove_all(roots_.sys);
  EXPECT_TRUE(found().empty());
}

TEST_F(CameraFinderTest, TheBoundCameraIsFoundByPortSerialOrPath) {
  add_usb(0, "1-1", "A");
  add_usb(2, "1-2", "B");
  const auto all = found();
  EXPECT_EQ(camera_that_fits(all, {.port = "1-2"}, "camera left")->serial, "B");
  EXPECT_EQ(camera_that_fits(all, {.serial = "A"}, "camera left")->port, "1-1");
  EXPECT_EQ(camera_that_fits(all, {.device = "/dev/video2"}, "camera left")->port, "1-2");
}

TEST_F(CameraFinderTest, PortAndSerialMustBothFit) {
  add_usb(0, "1-1", "A");
  const auto camera = camera_that_fits(found(), {.port = "1-1", .serial = "B"}, "camera left");
  ASSERT_FALSE(camera);
  EXPECT_EQ(camera.error().code, ErrorCode::kDeviceMissing);
  EXPECT_THAT(camera.error().message,
              AllOf(HasSubstr("camera left: no camera with port 1-1, serial B"), HasSubstr("check its cable"),
                    HasSubstr("`tripointd cameras`"), HasSubstr("/dev/video0 (port 1-1, serial A, Test camera)")));
}

TEST_F(CameraFinderTest, TwoThatFitAreNeverGuessedBetween) {
  add_usb(0, "1-1", "");
  add_usb(2, "1-2", "");
  const auto camera = camera_that_fits(found(), {}, "camera right");
  ASSERT_FALSE(camera);
  EXPECT_THAT(camera.error().message, AllOf(HasSubstr("2 cameras"), HasSubstr("1-1"), HasSubstr("1-2")));
}

}  // namespace
}  // namespace tripoint
