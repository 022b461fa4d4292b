"""The programs of the PLC guide, run with the vendors' clients: each gets poses, latches, and refuses a dead unit."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from host.plc_stage import LIMITS
from structured_text.execution import Runtime
from structured_text.fake_wire import LATCHED_SEQUENCE, SETUP, FakeWire
from structured_text.program import program_from
from structured_text.values import Value
from structured_text.vendor_clients import CLIENTS, Controller

GUIDE = (Path(__file__).parents[2] / "docs/guides/plc.md").read_text(encoding="utf-8")


def controller(vendor: str, folder: Path) -> Controller:
    section = re.split(r"^### ", GUIDE, flags=re.M)
    (shown,) = (part for part in section if part.startswith(vendor))
    (program,) = re.findall(r"^```iecst\n(.*?)^```", shown, re.M | re.S)
    return Controller(
        vendor, program.replace("limits.setup := 16#0000;", f"limits.setup := 16#{SETUP:04X};"), FakeWire(), folder
    )


def run(plc: Controller, cycles: int, latch: bool = False) -> None:
    for _ in range(cycles):
        plc.cycle(latch, LIMITS)


@pytest.mark.parametrize("vendor", CLIENTS)
def test_a_program_of_the_guide_gets_poses_and_latches_and_sees_the_cable_out(vendor: str, tmp_path: Path) -> None:
    plc = controller(vendor, tmp_path)
    wire = plc.wire
    assert isinstance(wire, FakeWire)
    seen = []
    for _ in range(40):
        run(plc, 1)
        if plc.said("live.new_pose"):
            seen.append(plc.said("live.sequence"))
    assert len(seen) >= 5
    assert seen == sorted(set(seen))  # every answer once, none twice
    assert plc.said("live.pose.x_mm") == pytest.approx(-12.345)
    for _ in range(100):
        run(plc, 1, latch=True)
        if plc.said("latched.valid"):
            break
    assert plc.said("latched.sequence") == LATCHED_SEQUENCE
    assert wire.written == [0, 0x0101]
    wire.down = True
    run(plc, 30)
    assert not plc.said("live.valid")
    wire.down = False
    run(plc, 30)
    assert plc.said("live.valid")


LOGIX = """FUNCTION_BLOCK Logix
VAR_INPUT
    answered : BOOL; heartbeat_timer : Timer; stored_setup, round_trip_us : DINT; Tripoint_measured_status : WORD;
    {numbers} : DINT;
END_VAR
VAR_OUTPUT
    pose_valid : INT;
END_VAR
{body}END_FUNCTION_BLOCK
TYPE Timer : STRUCT DN : BOOL; END_STRUCT END_TYPE
"""
LOGIX_POSE = {"sequence": 7, "sequence_end": 7, "setup": -21555, "age": 100_000} | {
    f"uncertainty_{axis}": 400_000 for axis in "xyz"
}


def logix_takes(folder: Path, answered: bool = True, status: int = 0x000F, late: bool = False, **spoilt: int) -> bool:
    """What the lines for Logix make of an answer; the setup is 0xABCD, as a signed number."""
    (body,) = re.findall(r"^```iecst\n(IF answered.*?)^```", GUIDE, re.M | re.S)
    file = folder / "logix.st"
    names = ", ".join(f"Tripoint_measured_{name}" for name in LOGIX_POSE)
    file.write_text(LOGIX.format(numbers=names, body=body), encoding="utf-8")
    runtime = Runtime(program_from([file]))
    block, timer = runtime.instance("Logix"), runtime.instance("Timer")
    timer.members["dn"] = Value("BOOL", late)
    numbers = {f"tripoint_measured_{name}": value for name, value in (LOGIX_POSE | spoilt).items()}
    numbers |= {"stored_setup": spoilt.get("stored_setup", -21555), "round_trip_us": 5000}
    numbers.pop("tripoint_measured_stored_setup", None)
    inputs: dict[str, Any] = {name: Value("DINT", value) for name, value in numbers.items()}
    inputs |= {"answered": Value("BOOL", answered), "tripoint_measured_status": Value("WORD", status)}
    runtime.call(block, inputs | {"heartbeat_timer": timer})
    return bool(block.members["pose_valid"].data)


def test_the_lines_for_logix_take_a_pose_that_may_be_used(tmp_path: Path) -> None:
    assert logix_takes(tmp_path)


@pytest.mark.parametrize(
    "spoilt",
    [
        {"answered": False},
        {"late": True},
        {"sequence_end": 8},
        {"status": 0x0007},
        {"status": 0x001F},
        {"status": 0x020F},
        {"setup": 5},
        {"setup": 0, "stored_setup": 0},
        {"age": 145_001},
        {"age": -1},
        {"uncertainty_x": -1},
        {"uncertainty_y": 500_001},
        {"uncertainty_z": -1},
    ],
    ids=str,
)
def test_the_lines_for_logix_refuse_any_other(spoilt: dict[str, Any], tmp_path: Path) -> None:
    assert not logix_takes(tmp_path, **spoilt)


@pytest.mark.parametrize("vendor", CLIENTS)
def test_an_answer_that_takes_longer_than_the_age_limit_gives_no_pose(vendor: str, tmp_path: Path) -> None:
    plc = controller(vendor, tmp_path)
    plc.takes = 25
    for _ in range(150):
        run(plc, 1)
        assert not plc.said("live.valid")
    assert plc.said("identified")
