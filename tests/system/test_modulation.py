"""One LED beside red lamps: told from them when it is modulated, refused otherwise, and never mistaken."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

import pytest
from system.daemon import ONE_LED, daemon, finished
from system.following import assert_follows

from host_tool.appliance.address import address_from
from host_tool.appliance.unit import Unit, open_unit
from host_tool.clock import MonotonicClock
from host_tool.contract.blocks import Answer
from host_tool.contract.conditions import faults_in
from host_tool.trajectories.paths import SCENARIOS
from host_tool.watching.session import Course, Scene, scenes

LAMPS = (ONE_LED, "simulation.red_lamps=3")
MODULATED = (*LAMPS, "modulation.enabled=true")
PROVING_S = 4.0  # from the first frames until LEDs are believed, on a busy machine
WATCHED_S = 6.0
LIMIT_S = 15.0


@contextmanager
def unit_with(folder: Path, *settings: str) -> Iterator[Unit]:
    with daemon(folder / "log", *settings) as started, open_unit(address_from(started.device), 2.0) as unit:
        time.sleep(PROVING_S)
        yield unit


def watched(unit: Unit) -> list[Scene]:
    return list(scenes(unit, MonotonicClock(), Course(SCENARIOS["paper-circular"], seconds=WATCHED_S)))


def fault_names(answer: Answer) -> set[str]:
    return {fault.name for fault in faults_in(answer.state.faults)}


def said(folder: Path, text: str) -> bool:
    deadline_s = time.monotonic() + LIMIT_S
    while time.monotonic() < deadline_s:
        if text in (folder / "log").read_text(encoding="utf-8"):
            return True
        time.sleep(0.1)
    return False


def test_a_modulated_led_is_measured_beside_red_lamps(tmp_path: Path) -> None:
    with unit_with(tmp_path, *MODULATED) as unit:
        *_, last = watched(unit)
    assert_follows(last.summary, valid_share=0.9, inside_share=0.95)  # lamps are more than 50 mm away


def test_without_modulation_the_same_scene_gives_no_pose(tmp_path: Path) -> None:
    with unit_with(tmp_path, *LAMPS) as unit:
        answers = [scene.sighting.answer for scene in watched(unit)]
    assert answers
    assert all(answer.pose.position_mm is None for answer in answers)
    assert "ambiguous" in fault_names(answers[-1])


@pytest.mark.parametrize(
    ("lines", "remark"),
    [("stuck_lit", "4 red lights shine on"), ("stuck_out", "3 red lights shine on")],
)
def test_a_stuck_line_gives_no_pose_and_is_said(tmp_path: Path, lines: str, remark: str) -> None:
    with unit_with(tmp_path, *MODULATED, f"simulation.led_lines={lines}") as unit:
        answers = [scene.sighting.answer for scene in islice(watched(unit), 20)]
        assert said(tmp_path, "no LED blinks, and " + remark)
    assert answers
    assert all(answer.pose.position_mm is None for answer in answers)
    assert {"not_seen_left", "not_seen_right"} <= fault_names(answers[-1])


TARGET = """
format = "tripoint-target/1"
detector = "led"
[[points]]
id = 21
position_mm = [0, 0, 0]
[[points]]
id = 22
position_mm = [80, 0, 0]
[[points]]
id = 23
position_mm = [20, 45, 0]
"""


def test_of_several_leds_each_is_found_and_no_lamp(tmp_path: Path) -> None:
    target = tmp_path / "target.toml"
    target.write_text(TARGET, encoding="utf-8")
    still = ("simulation.scenario=static-volume", f"target.file={target}")
    with unit_with(tmp_path, *MODULATED, *still) as unit:
        deadline_s = time.monotonic() + LIMIT_S
        seen: set[tuple[int | None, int | None]] = set()
        answer = unit.read_pose()
        while not ((3, 3) in seen and answer.pose.position_valid) and time.monotonic() < deadline_s:
            health = unit.read_health()
            seen.add((health.left.spots, health.right.spots))
            time.sleep(0.05)
            answer = unit.read_pose()
    assert (3, 3) in seen
    assert all(spots is not None and spots <= 3 for pair in seen for spots in pair)
    assert answer.pose.points_used == 3
    assert answer.pose.quaternion_wxyz is not None


def test_a_unit_whose_lines_nobody_switches_is_not_started(tmp_path: Path) -> None:
    config = tmp_path / "config.toml"
    config.write_text(
        '[cameras]\nleft.port = "1-1"\nright.port = "1-2"\n[volume]\nmin_mm = [0, 0, 300]\nmax_mm = [1, 1, 500]\n'
        "[modulation]\nenabled = true\n",
        encoding="utf-8",
    )
    run = finished("check-config", str(config))
    assert run.returncode != 0
    assert f"{config}:8: modulation.enabled = true: this version can only switch simulated lines" in run.stderr
