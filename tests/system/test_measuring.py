"""The unit on simulated cameras: alive, on the truth, and honest about it."""

import json
import time
from collections.abc import Iterator
from itertools import islice
from typing import Any

import pytest
from system.daemon import Daemon, daemon
from system.following import assert_follows

from host_tool.appliance.address import address_from
from host_tool.appliance.modbus import RefusedError, Table
from host_tool.appliance.unit import Unit, open_unit
from host_tool.cli.main import run
from host_tool.clock import MonotonicClock
from host_tool.contract.conditions import Status, faults_in
from host_tool.errors import ExitCode
from host_tool.trajectories.paths import SCENARIOS
from host_tool.watching.session import Course, scenes

FRAME_RATE_HZ = 30.0
SETTLE_S = 5.0  # as the demo
LATCH = 0x0100
COMMAND = 1000


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    with daemon(tmp_path_factory.mktemp("daemon") / "log") as started:
        time.sleep(SETTLE_S)
        yield started


@pytest.fixture
def unit(running: Daemon) -> Iterator[Unit]:
    with open_unit(address_from(running.device), 2.0) as opened:
        yield opened


def test_the_heart_beats_with_the_frames(unit: Unit) -> None:
    first, started_s = unit.read_pose().state.heartbeat, time.monotonic()
    time.sleep(2.0)
    beats = (unit.read_pose().state.heartbeat - first) % 65536
    rate_hz = beats / (time.monotonic() - started_s)
    # Up to two common times a frame period with free-running cameras; a busy machine may drop half of the frames.
    assert FRAME_RATE_HZ / 2 <= rate_hz <= 2.2 * FRAME_RATE_HZ


def test_poses_follow_the_truth_and_know_how_well(unit: Unit) -> None:
    course = Course(SCENARIOS["paper-circular"], seconds=6.0)
    *_, last = scenes(unit, MonotonicClock(), course)
    assert_follows(last.summary, valid_share=0.95, inside_share=0.85)


def test_a_simulated_pose_says_so(unit: Unit) -> None:
    pose = unit.read_pose().pose
    assert pose.status & Status.SIMULATED
    assert not pose.status & Status.STALE


def test_age_is_that_of_the_exposure_by_this_computers_clock(unit: Unit) -> None:
    pose = unit.read_pose().pose
    assert pose.age_ms is not None
    by_clock_ms = (time.time_ns() - pose.exposed_utc_ns) / 1e6
    assert by_clock_ms - 20.0 <= pose.age_ms <= by_clock_ms  # between answer and this line: one round trip


def test_a_latch_is_done_and_stays(unit: Unit) -> None:
    link = unit.link
    try:
        link.write(COMMAND, 0)
    except RefusedError:
        pytest.fail("the demo's configuration must name 127.0.0.1 in modbus.command_clients")
    link.write(COMMAND, LATCH | 7)
    deadline_s = time.monotonic() + 2.0
    while (words := state_words(unit))[1] not in (2, 3) and time.monotonic() < deadline_s:
        time.sleep(0.01)
    link.write(COMMAND, 0)
    assert words[:3] == (LATCH | 7, 2, 0)
    first = latched(unit)
    time.sleep(0.2)
    again = latched(unit)
    assert first["sequence"] == again["sequence"]
    assert first["position"] == again["position"]


def state_words(unit: Unit) -> tuple[int, ...]:
    return unit.link.read(Table.INPUT, 40, 4)


def latched(unit: Unit) -> dict[str, Any]:
    words = unit.link.read(Table.INPUT, 400, 48)
    return {"sequence": words[0], "position": words[10:16]}


def test_host_tool_watches_the_real_unit(running: Daemon, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["watch", "--json", "--count", "10", "--truth", "paper-circular", "--device", running.device]) == 0
    records = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert len({record["sequence"] for record in records}) == 10
    assert all("simulated" in record["status"] for record in records)


def test_host_tool_gives_a_status(running: Daemon, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["status", "--json", "--device", running.device]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["state"]["state"] == "measuring"
    assert record["cameras"]["left"]["state"] == "delivering"


@pytest.mark.parametrize(
    ("options", "code"),
    [((), ExitCode.PASS), (("--word-order", "abcd"), ExitCode.PASS), (("--offset", "1"), ExitCode.FAILED)],
)
def test_the_probe_judges_a_client(running: Daemon, options: tuple[str, ...], code: int) -> None:
    assert run(["plc", "probe", *options, "--device", running.device]) == code


def test_the_demo_passes(running: Daemon, capsys: pytest.CaptureFixture[str]) -> None:
    code = run(["demo", "--seconds", "12", "--device", running.device])
    assert code == ExitCode.PASS, capsys.readouterr().out


@pytest.mark.parametrize(
    ("settings", "fault"),
    [
        (("cameras.source=v4l2", "cameras.left.port=9-9.9", "cameras.right.port=9-9.8"), "left_camera_lost"),
        (("calibration.file=",), "no_calibration"),
    ],
)
def test_a_unit_that_cannot_measure_serves_and_says_why(
    tmp_path_factory: pytest.TempPathFactory, settings: tuple[str, ...], fault: str
) -> None:
    with daemon(tmp_path_factory.mktemp("daemon") / "log", *settings) as started:
        time.sleep(1.0)
        with open_unit(started.address, 2.0) as unit:
            answers = [scene.sighting.answer for scene in islice(scenes(unit, MonotonicClock(), Course()), 2)]
        assert fault in {condition.name for condition in faults_in(answers[-1].state.faults)}
        assert not answers[-1].pose.position_valid
        assert started.process.poll() is None
