"""The simulated cameras alone, seen by v4l2-ctl through the stock driver: can the other tests trust them?"""
# ruff: noqa: PT009, PT027 (unittest: the virtual machine brings the standard library only)

import struct
import subprocess
import tempfile
import time
import unittest
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path

from cameras import SERIALS, SIDES, load_drivers, node_of
from environment import environment

EXTENSIONS = {"YUYV": "yuyv", "MJPG": "jpg"}


def v4l2(node: str, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["v4l2-ctl", "-d", node, *options], capture_output=True, text=True, timeout=60, check=False)


@contextmanager
def streaming(node: str, *options: str) -> Iterator[subprocess.Popen[bytes]]:
    """A stream that is ended whatever happens to the test."""
    command = ["v4l2-ctl", "-d", node, "--stream-mmap", *options]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as stream:
        try:
            yield stream
        finally:
            stream.kill()


def metadata_node_of(node: str) -> str:
    return f"/dev/video{int(node.removeprefix('/dev/video')) + 1}"


def picture_times(records: bytes) -> Iterator[int]:
    """From the driver's metadata format UVCH: u64 host time, u16 host frame number, then the payload header itself."""
    at = 0
    while at + 12 <= len(records):
        length, flags = records[at + 10], records[at + 11]
        if length >= 6 and flags & 1 << 2:
            yield struct.unpack_from("<I", records, at + 12)[0]
        at += 10 + max(length, 2)


def without_huffman_tables(picture: bytes) -> bytes:
    """A webcam leaves them out of a JPEG; other pictures stay as they are."""
    if not picture.startswith(b"\xff\xd8"):
        return picture
    bare, at = picture[:2], 2
    while picture[at + 1] != 0xDA:
        end = at + 2 + int.from_bytes(picture[at + 2 : at + 4])
        bare += b"" if picture[at + 1] == 0xC4 else picture[at:end]
        at = end
    return bare + picture[at:]


class CamerasTest(unittest.TestCase):
    def setUp(self) -> None:
        load_drivers()
        self.world = environment()
        self.nodes = {side: self.world.cameras.plug(side) for side in SIDES}

    def tearDown(self) -> None:
        for side in SIDES:
            if node_of(side):
                self.world.cameras.unplug(side)

    def pictures(self, format_name: str, side: str) -> set[bytes]:
        files = (self.world.recordings[format_name] / side).glob(f"*.{EXTENSIONS[format_name]}")
        return {without_huffman_tables(file.read_bytes()) for file in files}

    def captured(self, format_name: str, side: str) -> bytes:
        """One frame, as the driver hands it out."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "frame"
            v4l2(self.nodes[side], f"--set-fmt-video=width=640,height=480,pixelformat={format_name}")
            run = v4l2(self.nodes[side], "--stream-mmap", "--stream-skip=2", "--stream-count=1", f"--stream-to={file}")
            self.assertEqual(run.returncode, 0, run.stderr)
            return file.read_bytes()

    def test_frames_arrive_byte_for_byte_in_both_formats(self) -> None:
        for format_name in EXTENSIONS:
            for side in SIDES:
                with self.subTest(format=format_name, side=side):
                    self.assertIn(self.captured(format_name, side), self.pictures(format_name, side))

    def test_time_stamps_of_the_camera_count_whole_frames(self) -> None:
        node = self.nodes["left"]
        v4l2(node, "--set-fmt-video=width=640,height=480,pixelformat=MJPG")
        with streaming(node):
            headers = self.payload_headers(metadata_node_of(node))
        ticks_per_frame = 48_000_000 // 30
        steps = {(later - earlier) % 2**32 for earlier, later in pairwise(headers)}
        self.assertTrue(steps, "no time stamps at all")
        for step in steps:
            # The interval is 333333 x 100 ns, 1.6 ticks short of 1/30 s, and a time is cut to a tick.
            frames = round(step / ticks_per_frame)
            self.assertLessEqual(abs(step - frames * ticks_per_frame), 2 + 1.6 * frames)

    def payload_headers(self, node: str) -> list[int]:
        """The picture times (PTS) in the order in which they came, from the driver's own record of the headers."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "headers"
            run = v4l2(node, "--stream-mmap", "--stream-count=20", f"--stream-to={file}")
            self.assertEqual(run.returncode, 0, run.stderr)
            return list(picture_times(file.read_bytes()))

    def test_manual_exposure_is_refused_while_automatic_and_held_afterwards(self) -> None:
        node = self.nodes["left"]
        v4l2(node, "--set-ctrl=exposure_time_absolute=20")
        self.assertNotEqual(self.world.cameras.settings("left")["exposure_time"], 20)
        v4l2(node, "--set-ctrl=auto_exposure=1")
        v4l2(node, "--set-ctrl=exposure_time_absolute=20,gain=33")
        held = self.world.cameras.settings("left")
        self.assertEqual((held["exposure_mode"], held["exposure_time"], held["gain"]), (1, 20, 33))
        self.assertEqual(self.world.cameras.settings("right")["gain"], 64)

    def test_unplugging_ends_a_stream_and_plugging_brings_the_camera_back(self) -> None:
        with streaming(self.nodes["left"]) as stream:
            time.sleep(3)
            self.assertIsNone(stream.poll(), "it should still stream")
            self.world.cameras.unplug("left")
            stream.wait(timeout=30)
        self.assertIsNotNone(node_of("right"), "only the left one was pulled out")
        self.world.cameras.plug("left")
        self.nodes["left"] = node_of("left") or ""
        self.assertIn(self.captured("MJPG", "left"), self.pictures("MJPG", "left"))

    def test_a_hung_camera_sends_nothing_until_it_is_released(self) -> None:
        self.assertEqual(self.world.cameras.order("hang right"), "done")
        with streaming(self.nodes["right"], "--stream-count=1") as stream:
            with self.assertRaises(subprocess.TimeoutExpired):
                stream.wait(timeout=5)
            self.assertEqual(self.world.cameras.order("resume right"), "done")
            self.assertEqual(stream.wait(timeout=30), 0)

    def test_serials_are_those_that_the_configuration_binds(self) -> None:
        found = {file.read_text().strip() for file in Path("/sys/bus/usb/devices").glob("*/serial")}
        self.assertLessEqual(set(SERIALS.values()), found)


if __name__ == "__main__":
    unittest.main()
