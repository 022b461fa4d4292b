"""A camera that is missing: no pose, the cause in the registers and in the log, and measuring resumes by itself."""

import csv
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

from system.daemon import CONFIG, ONE_LED, STOP_S, daemon, renderer

from host_tool.appliance.address import address_from
from host_tool.appliance.unit import Unit, open_unit
from host_tool.contract.blocks import Answer
from host_tool.contract.conditions import faults_in

FRAMES = 180  # 6 s
GAP = range(75, 120)  # frames of the right camera that never came: 2.5 s to 4 s
LIMIT_S = 10.0


def recording_with_a_gap(folder: Path) -> Path:
    command = [renderer(), "--frames", str(FRAMES), "--scenario", "scout", "--format", "jpg", "--out", str(folder)]
    subprocess.run(command, check=True, timeout=120.0)
    frames = folder / "frames.csv"
    with frames.open(newline="", encoding="utf-8") as lines:
        header, *rows = csv.reader(lines)
    kept = [row for row in rows if not (row[0] == "right" and int(row[1]) in GAP)]
    assert len(rows) - len(kept) == len(GAP)
    frames.write_text("\n".join(",".join(row) for row in [header, *kept]) + "\n", encoding="utf-8")
    return folder


def wait_for(unit: Unit, condition: Callable[[Answer], bool]) -> Answer:
    deadline_s = time.monotonic() + LIMIT_S
    while time.monotonic() < deadline_s:
        answer = unit.read_pose()
        if condition(answer):
            return answer
        time.sleep(0.02)
    raise AssertionError(f"not within {LIMIT_S} s; the last answer: {unit.read_pose()}")


def without_right(answer: Answer) -> bool:
    return "right_camera_lost" in {fault.name for fault in faults_in(answer.state.faults)}


def test_a_lost_camera_takes_the_pose_with_it_and_brings_it_back(tmp_path: Path) -> None:
    folder = recording_with_a_gap(tmp_path / "recording")
    settings = (ONE_LED, "cameras.source=recording", f"recording.folder={folder}")
    with daemon(tmp_path / "log", *settings) as started, open_unit(address_from(started.device), 2.0) as unit:
        wait_for(unit, lambda answer: answer.pose.position_mm is not None)
        lost = wait_for(unit, without_right)
        assert lost.pose.position_mm is None

        def back(answer: Answer) -> bool:
            if not without_right(answer):
                return answer.pose.position_mm is not None
            assert answer.state.heartbeat == lost.state.heartbeat, "the heart beats although nothing is measured"
            assert answer.pose.position_mm is None
            return False

        wait_for(unit, back)
    assert "camera right" in (tmp_path / "log").read_text(encoding="utf-8")


def config_of_absent_cameras(folder: Path) -> Path:
    serials = 'left.serial = "LEFT-001"\nright.serial = "RIGHT-001"'
    text = CONFIG.read_text(encoding="utf-8").replace('source = "simulation"', f'source = "v4l2"\n{serials}')
    config = folder / "absent.toml"
    for name in ("calibration.toml", "target.toml"):
        (folder / name).symlink_to(CONFIG.parent / name)
    config.write_text(text, encoding="utf-8")
    return config


def test_without_its_cameras_a_unit_stays_says_which_are_missing_and_what_to_do(tmp_path: Path) -> None:
    def both_lost(answer: Answer) -> bool:
        faults = {fault.name for fault in faults_in(answer.state.faults)}
        return {"left_camera_lost", "right_camera_lost"} <= faults

    with daemon(tmp_path / "log", config=config_of_absent_cameras(tmp_path)) as started:
        with open_unit(address_from(started.device), 2.0) as unit:
            answer = wait_for(unit, both_lost)
            assert answer.state.heartbeat == 0
            assert answer.pose.position_mm is None
        assert started.process.poll() is None
        started.process.terminate()
        assert started.process.wait(timeout=10.0 * STOP_S) == 0
    log = (tmp_path / "log").read_text(encoding="utf-8")
    for side, serial in (("left", "LEFT-001"), ("right", "RIGHT-001")):
        assert f"camera {side}: no camera with serial {serial}: check its cable" in log
    assert "`tripointd cameras`" in log
