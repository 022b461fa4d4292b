"""The whole way: pictures with a known truth, USB, the stock driver, V4L2, tripointd, Modbus."""
# ruff: noqa: PT009 (unittest: the virtual machine brings the standard library only)

import subprocess
import time
import unittest
from typing import ClassVar

from cameras import SIDES, Cameras, eventually, load_drivers, node_of
from daemon import Daemon
from environment import environment
from modbus_client import LEFT_LOST, RIGHT_LOST, Reading
from stations import Station, stations_of

POSES_PER_STATION = 10
# Verdicts to let pass after other pictures are shown: more than driver, USB and capture can hold (4 + 5 + 2 frames).
SETTLING_VERDICTS = 30
# Five standard deviations; the published uncertainty is two of them. For 3 axes, 10 poses, 3 stations and 2 formats the
# chance that a right pose fails is 180 x 5.7e-7 = 1e-4. The register is rounded to 1 um.
UNCERTAINTIES = 2.5
ROUNDING_MM = 0.001
# At 480 mm, 100 mm between the cameras and f = 628 px, a pixel of disparity is 480^2 / (100 x 628) = 3.7 mm of depth.
# 0.4 px (k = 2) is 0.14 px for each camera, nearly three times the fit of a spot, with room for what the unknown
# offset of the clocks adds: a unit that publishes more guesses.
UNCERTAINTY_LIMIT_MM = 1.5
LOST = {"left": LEFT_LOST, "right": RIGHT_LOST}
STANDSTILL_S = 3.0  # for a heart that beats even ten times slower than the cameras


def held_by_driver(side: str) -> set[str]:
    """What a second program reads while the first one streams."""
    command = ["v4l2-ctl", "-d", node_of(side) or "", "--get-ctrl=exposure_time_absolute,gain"]
    return set(subprocess.run(command, capture_output=True, text=True, timeout=60, check=True).stdout.splitlines())


class Line(unittest.TestCase):
    """The tests of one pixel format; one daemon lives through all of them."""

    format_name: ClassVar[str]
    cameras: ClassVar[Cameras]
    stations: ClassVar[list[Station]]
    daemon: ClassVar[Daemon]

    @classmethod
    def setUpClass(cls) -> None:
        load_drivers()
        world = environment()
        cls.cameras = world.cameras
        cls.stations = stations_of(world.recordings[cls.format_name])
        cls.daemon = Daemon(world, cls.format_name)
        cls.daemon.start()

    @classmethod
    def tearDownClass(cls) -> None:
        code = cls.daemon.stop()
        for side in SIDES:
            if node_of(side):
                cls.cameras.unplug(side)
        if code != 0:
            raise AssertionError(f"tripointd was asked to stop and gave {code}")

    def setUp(self) -> None:
        """Both cameras in and well, the target at the first station, a pose published."""
        self.show(self.stations[0])
        for side in SIDES:
            if node_of(side) is None:
                self.cameras.plug(side)
            self.cameras.order(f"resume {side}")
        eventually("a valid pose", self.daemon.valid_reading)

    def show(self, station: Station) -> None:
        self.assertEqual(self.cameras.order(f"show {station.first} {station.count}"), "done")

    def settle(self) -> None:
        start = self.daemon.reading().sequence
        eventually("new verdicts", lambda: (self.daemon.reading().sequence - start) % 2**16 > SETTLING_VERDICTS)

    def poses(self, count: int) -> list[Reading]:
        """Valid poses of different exposures."""
        poses: dict[int, Reading] = {}

        def enough() -> bool:
            pose = self.daemon.valid_reading()
            if pose is not None:
                poses[pose.sequence] = pose
            return len(poses) >= count

        eventually(f"{count} valid poses", enough)
        return list(poses.values())

    def assert_agrees(self, pose: Reading, station: Station) -> None:
        for measured, true, uncertainty in zip(pose.position_mm, station.position_mm, pose.uncertainty_mm, strict=True):
            self.assertLess(uncertainty, UNCERTAINTY_LIMIT_MM)
            self.assertLessEqual(abs(measured - true), UNCERTAINTIES * uncertainty + ROUNDING_MM, pose)

    def assert_lost(self, side: str) -> None:
        """The fault names the camera, nothing is valid, unknown is not a number, the heart stands still."""
        lost = eventually(f"camera {side} reported lost", lambda: self.reading_with_fault(LOST[side]))
        self.assertFalse(lost.valid)
        self.assertTrue(lost.position_unknown)
        other = next(name for name in SIDES if name != side)
        self.assertFalse(lost.faults & LOST[other], "the other camera is well")
        time.sleep(STANDSTILL_S)
        later = self.daemon.reading()
        self.assertEqual(later.heartbeat, lost.heartbeat)
        self.assertTrue(later.faults & LOST[side])
        self.assertFalse(later.valid)

    def reading_with_fault(self, fault: int) -> Reading | None:
        seen = self.daemon.reading()
        return seen if seen.faults & fault else None

    def both_lost(self) -> bool:
        return self.daemon.reading().faults & (LEFT_LOST | RIGHT_LOST) == LEFT_LOST | RIGHT_LOST

    def assert_measures_again(self) -> None:
        again = eventually("a valid pose again", self.daemon.valid_reading)
        self.assertFalse(again.faults & (LEFT_LOST | RIGHT_LOST))
        self.settle()
        for pose in self.poses(3):
            self.assert_agrees(pose, self.stations[0])

    def test_poses_agree_with_the_truth_in_the_pictures(self) -> None:
        for station in self.stations:
            self.show(station)
            self.settle()
            for pose in self.poses(POSES_PER_STATION):
                with self.subTest(station=station.position_mm, sequence=pose.sequence):
                    self.assert_agrees(pose, station)

    def test_an_unplugged_camera_is_reported_and_comes_back_by_itself(self) -> None:
        for side in SIDES:
            with self.subTest(side=side):
                self.cameras.unplug(side)
                self.assert_lost(side)
                self.cameras.plug(side)
                self.assert_measures_again()

    def test_a_hung_camera_is_reported_and_comes_back_by_itself(self) -> None:
        self.assertEqual(self.cameras.order("hang right"), "done")
        self.assert_lost("right")
        self.assertEqual(self.cameras.order("resume right"), "done")
        self.assert_measures_again()

    def test_stale_pictures_are_not_measured_and_the_cameras_opened_anew(self) -> None:
        """One frozen picture, and a driver that goes round in four."""
        for count in (1, 4):
            with self.subTest(pictures=count):
                self.assert_stale_pictures_are_noticed(count)
                self.show(self.stations[0])
                self.assert_measures_again()

    def assert_stale_pictures_are_noticed(self, count: int) -> None:
        noticed = self.daemon.log.read_text().count("frozen")
        self.assertEqual(self.cameras.order(f"freeze {self.stations[0].first} {count}"), "done")
        eventually("both cameras lost", self.both_lost)
        eventually("closed", lambda: self.daemon.log.read_text().count("frozen") > noticed)
        heartbeat = self.daemon.reading().heartbeat
        time.sleep(STANDSTILL_S)
        later = self.daemon.reading()
        self.assertEqual((later.heartbeat, later.valid), (heartbeat, False))

    def test_the_cameras_hold_the_settings_of_the_configuration(self) -> None:
        for side in SIDES:
            with self.subTest(side=side):
                held = self.cameras.settings(side)
                self.assertEqual(held["exposure_mode"], 1, "manual")
                self.assertEqual(held["exposure_priority"], 0, "the rate must not follow the light")
                self.assertEqual((held["white_balance_auto"], held["focus_auto"]), (0, 0))
                self.assertEqual((held["exposure_time"], held["gain"]), (20, 33), "2000 us; gain 33")
                self.assertEqual(held_by_driver(side), {"exposure_time_absolute: 20", "gain: 33"})


class YuyvTest(Line):
    format_name = "YUYV"


class MjpegTest(Line):
    format_name = "MJPG"


def load_tests(loader: unittest.TestLoader, tests: unittest.TestSuite, pattern: str | None) -> unittest.TestSuite:
    """Only the formats, not what they have in common."""
    del tests, pattern
    return unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in (YuyvTest, MjpegTest))
