#include "fake_v4l2_driver.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace tripoint::test {
namespace {

template <typename T>
T& as(void* argument) {
  return *static_cast<T*>(argument);
}

}  // namespace

FakeV4l2Driver::FakeV4l2Driver(WaitingClock& clock) : clock_(clock) {
  capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  fourcc = V4L2_PIX_FMT_YUYV;
  controls = {{V4L2_CID_EXPOSURE_AUTO, {1, 3, V4L2_EXPOSURE_APERTURE_PRIORITY}},
              {V4L2_CID_EXPOSURE_AUTO_PRIORITY, {0, 1, 1}},
              {V4L2_CID_EXPOSURE_ABSOLUTE, {1, 5000, 157}},
              {V4L2_CID_GAIN, {0, 255, 64}},
              {V4L2_CID_AUTO_WHITE_BALANCE, {0, 1, 1}},
              {V4L2_CID_WHITE_BALANCE_TEMPERATURE, {2000, 6500, 4000}},
              {V4L2_CID_FOCUS_AUTO, {0, 1, 1}},
              {V4L2_CID_FOCUS_ABSOLUTE, {0, 250, 30}}};
}

int FakeV4l2Driver::open(const std::filesystem::path& node) {
  if (open_failure < 0) return open_failure;
  log.push_back("open " + node.string());
  return ::open("/dev/null", O_RDWR | O_CLOEXEC);
}

int FakeV4l2Driver::control(int, unsigned long request, void* argument) {
  const auto failure = failures.find(request);
  if (failure != failures.end()) return failure->second;
  static const std::map<unsigned long, int (FakeV4l2Driver::*)(void*)> answers{
      {VIDIOC_QUERYCAP, &FakeV4l2Driver::describe_capability},
      {VIDIOC_S_FMT, &FakeV4l2Driver::set_format},
      {VIDIOC_S_PARM, &FakeV4l2Driver::set_rate},
      {VIDIOC_ENUM_FMT, &FakeV4l2Driver::offer_format},
      {VIDIOC_ENUM_FRAMESIZES, &FakeV4l2Driver::offer_size},
      {VIDIOC_ENUM_FRAMEINTERVALS, &FakeV4l2Driver::offer_rate},
      {VIDIOC_QUERYCTRL, &FakeV4l2Driver::describe_control},
      {VIDIOC_S_CTRL, &FakeV4l2Driver::set_control},
      {VIDIOC_G_CTRL, &FakeV4l2Driver::read_control},
      {VIDIOC_REQBUFS, &FakeV4l2Driver::give_buffers},
      {VIDIOC_QUERYBUF, &FakeV4l2Driver::describe_buffer},
      {VIDIOC_QBUF, &FakeV4l2Driver::queue},
      {VIDIOC_DQBUF, &FakeV4l2Driver::dequeue}};
  if (request == VIDIOC_STREAMON) return log.emplace_back("on"), 0;
  if (request == VIDIOC_STREAMOFF) return log.emplace_back("off"), 0;
  const auto answer = answers.find(request);
  return answer == answers.end() ? -ENOTTY : (this->*answer->second)(argument);
}

int FakeV4l2Driver::wait(int, Duration limit) {
  if (waits.empty()) return clock_.pass(limit), 0;
  const FakeWait next = waits.front();
  waits.pop_front();
  clock_.pass(next.after);
  ready_.insert(ready_.end(), next.frames.begin(), next.frames.end());
  return next.events;
}

void* FakeV4l2Driver::map(int, std::size_t length, std::int64_t) {
  if (map_fails) return nullptr;
  void* memory = ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  memory_.push_back(memory);
  return memory;
}

std::uint32_t FakeV4l2Driver::row_bytes() const {
  return width * (fourcc == V4L2_PIX_FMT_GREY ? 1 : 2) + padding_bytes;
}

std::uint32_t FakeV4l2Driver::image_bytes() const { return row_bytes() * height; }

int FakeV4l2Driver::describe_capability(void* argument) {
  as<v4l2_capability>(argument).capabilities = capabilities | V4L2_CAP_DEVICE_CAPS;
  as<v4l2_capability>(argument).device_caps = capabilities;
  return 0;
}

int FakeV4l2Driver::set_format(void* argument) {
  v4l2_pix_format& pix = as<v4l2_format>(argument).fmt.pix;
  pix.width = width;
  pix.height = height;
  pix.pixelformat = fourcc;
  pix.field = field;
  pix.bytesperline = fourcc == V4L2_PIX_FMT_MJPEG ? 0 : row_bytes();
  pix.sizeimage = image_bytes();
  return 0;
}

int FakeV4l2Driver::set_rate(void* argument) {
  as<v4l2_streamparm>(argument).parm.capture.timeperframe = {rate_numerator, rate_denominator};
  return 0;
}

int FakeV4l2Driver::offer_format(void* argument) {
  auto& offer = as<v4l2_fmtdesc>(argument);
  offer.pixelformat = fourcc;
  return offer.index == 0 ? 0 : -EINVAL;
}

int FakeV4l2Driver::offer_size(void* argument) {
  auto& offer = as<v4l2_frmsizeenum>(argument);
  offer.type = V4L2_FRMSIZE_TYPE_DISCRETE;
  offer.discrete = {width, height};
  return offer.index == 0 ? 0 : -EINVAL;
}

int FakeV4l2Driver::offer_rate(void* argument) {
  auto& offer = as<v4l2_frmivalenum>(argument);
  offer.type = V4L2_FRMIVAL_TYPE_DISCRETE;
  offer.discrete = {rate_numerator, rate_denominator};
  return offer.index == 0 ? 0 : -EINVAL;
}

int FakeV4l2Driver::describe_control(void* argument) {
  auto& description = as<v4l2_queryctrl>(argument);
  const auto found = controls.find(description.id);
  if (found == controls.end()) return -EINVAL;
  description.minimum = found->second.minimum;
  description.maximum = found->second.maximum;
  description.step = 1;
  return 0;
}

int FakeV4l2Driver::set_control(void* argument) {
  const auto& wanted = as<v4l2_control>(argument);
  FakeControl& control = controls.at(wanted.id);
  if (!control.stuck) control.value = std::clamp(wanted.value, control.minimum, control.maximum);
  return 0;
}

int FakeV4l2Driver::read_control(void* argument) {
  auto& asked = as<v4l2_control>(argument);
  asked.value = controls.at(asked.id).value;
  return 0;
}

int FakeV4l2Driver::give_buffers(void* argument) {
  memory_.clear();
  queued_.clear();
  as<v4l2_requestbuffers>(argument).count = buffers_given;
  return 0;
}

int FakeV4l2Driver::describe_buffer(void* argument) {
  as<v4l2_buffer>(argument).length = image_bytes();
  return 0;
}

int FakeV4l2Driver::queue(void* argument) {
  queued_.push_back(as<v4l2_buffer>(argument).index);
  return 0;
}

int FakeV4l2Driver::dequeue(void* argument) {
  if (std::exchange(lost_, false)) return -EIO;
  if (ready_.empty() || queued_.empty()) return -EAGAIN;
  const FakeFrame frame = ready_.front();
  ready_.pop_front();
  lost_ = frame.lost_after;
  auto& buffer = as<v4l2_buffer>(argument);
  buffer.index = queued_.front();
  queued_.pop_front();
  std::memset(memory_[buffer.index], frame.value, image_bytes());
  buffer.bytesused = image_bytes() - frame.missing_bytes;
  buffer.sequence = frame.sequence;
  buffer.timestamp = {.tv_sec = frame.stamp_us / 1'000'000, .tv_usec = frame.stamp_us % 1'000'000};
  buffer.flags = (frame.damaged ? V4L2_BUF_FLAG_ERROR : 0U) |
                 (frame.monotonic ? V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC : V4L2_BUF_FLAG_TIMESTAMP_UNKNOWN) |
                 V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
  return 0;
}

}  // namespace tripoint::test
