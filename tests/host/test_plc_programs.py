"""The programs of the PLC guide, run with the vendors' clients: each gets poses, latches, and refuses a dead unit."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from host.plc_stage import LIMITS
from structured_text.fake_wire import LATCHED_SEQUENCE, SETUP, FakeWire
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


@pytest.mark.parametrize("vendor", CLIENTS)
def test_an_answer_that_takes_longer_than_the_age_limit_gives_no_pose(vendor: str, tmp_path: Path) -> None:
    plc = controller(vendor, tmp_path)
    plc.takes = 25
    for _ in range(150):
        run(plc, 1)
        assert not plc.said("live.valid")
    assert plc.said("identified")
