"""What is in deploy/plc against the real unit: the poses it takes are those that host-tool reads, and it latches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from structured_text.plc import Plc, shipped_program
from structured_text.program import Program
from structured_text.urscript import Robot
from system.daemon import Daemon, daemon

from host_tool.appliance.modbus import ModbusLink, Table
from host_tool.clock import MonotonicClock
from host_tool.contract.blocks import Pose
from host_tool.contract.decode import pose_of, words_of

POSE_IN_ANSWER = 100 - 32
NEVER = 10_000  # cycles: some 30 s
LIMITS = {
    "age_ms": 200,
    "latched_age_ms": 5000,
    "uncertainty_mm": 2.0,
    "uncertainty_deg": 5.0,
    "orientation": True,
    "simulated": True,
}


@dataclass(frozen=True, slots=True)
class Link:
    """The PLC's wire over host-tool's own Modbus client."""

    modbus: ModbusLink

    def read(self, address: int, quantity: int) -> Sequence[int]:
        return self.modbus.read(Table.HOLDING, address, quantity)

    def write(self, address: int, value: int) -> None:
        self.modbus.write(address, value)


@pytest.fixture(scope="module")
def program() -> Program:
    return shipped_program()


@pytest.fixture(scope="module")
def unit(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    with daemon(tmp_path_factory.mktemp("daemon") / "log") as running:
        yield running


@pytest.fixture
def plc(program: Program, unit: Daemon) -> Iterator[Plc]:
    with ModbusLink(unit.address, 2.0) as link:
        setup = link.read(Table.HOLDING, 146, 1)[0]
        yield Plc(program, Link(link), {**LIMITS, "setup": setup})


def until(plc: Plc, wanted: str, latch: bool = False) -> None:
    """Cycles in real time until an output is TRUE."""
    clock = MonotonicClock()
    for _ in range(NEVER):
        plc.cycle(round(clock.now_s() * 1000.0), latch)
        if plc.said(wanted):
            return
    pytest.fail(f"{wanted} stays FALSE, reason {plc.said('live.reason')}, faults {plc.said('live.faults'):#06x}")


def same_pose(plc: Plc, verdict: str, pose: Pose) -> None:
    """What the blocks say is what host-tool makes of the same registers."""
    said: dict[str, Any] = {
        name: plc.said(f"{verdict}.pose.{name}") for name in plc.unit.members[verdict].members["pose"].members
    }
    assert pose.position_mm is not None
    assert pose.angles_deg is not None
    assert pose.quaternion_wxyz is not None
    assert pose.uncertainty_mm is not None
    assert pose.uncertainty_deg is not None
    read = (*pose.position_mm, *pose.angles_deg, *pose.quaternion_wxyz, *pose.uncertainty_mm, *pose.uncertainty_deg)
    assert list(said.values()) == pytest.approx(list(read), abs=1e-9)
    assert plc.said(f"{verdict}.sequence") == pose.sequence & 0xFFFF
    assert plc.said(f"{verdict}.setup") == pose.setup


def test_each_new_pose_is_the_one_that_host_tool_reads(plc: Plc) -> None:
    for _ in range(10):
        until(plc, "live.new_pose")
        pose = pose_of(words_of("measured", plc.words[POSE_IN_ANSWER:]))
        same_pose(plc, "live", pose)
        assert pose.age_ms is not None
        assert pose.age_ms < plc.said("live.age_ms") <= LIMITS["age_ms"]  # the way here counts


def test_a_latched_pose_is_the_copy_that_the_unit_holds(plc: Plc) -> None:
    until(plc, "live.valid")
    until(plc, "latch_done", latch=True)
    until(plc, "latched.valid", latch=True)
    with_copy = Link(plc.wire.modbus).read(400, 48)  # type: ignore[attr-defined]
    same_pose(plc, "latched", pose_of(words_of("latched", with_copy)))


def without_simulated(address: int, link: ModbusLink) -> int:
    word = link.read(Table.INPUT, address, 1)[0]
    return word & ~(1 << 9) if address == 449 else word


def test_a_universal_robot_latches_and_reads_the_same_pose(unit: Daemon) -> None:
    with ModbusLink(unit.address, 2.0) as link:
        setup = link.read(Table.HOLDING, 146, 1)[0]
        # The script takes no pose of a simulation: this is what it would read in a machine.
        robot = Robot(lambda at: without_simulated(at, link), link.write, MonotonicClock().sleep)
        functions = robot.functions()
        functions["tripoint_connect"]("127.0.0.1")
        seen = functions["tripoint_latch"](setup, 2000, 5000, False)
        copy = words_of("latched_single", link.read(Table.HOLDING, 448, 16))
    assert seen[0] == 0
    millimetres = copy.triple("x", "y", "z")
    rotation = copy.triple("rotation_x", "rotation_y", "rotation_z")
    assert millimetres is not None
    assert rotation is not None
    assert seen[1:] == pytest.approx([*(value / 1000.0 for value in millimetres), *rotation], abs=1e-9)


def test_a_universal_robot_refuses_a_simulation(unit: Daemon) -> None:
    with ModbusLink(unit.address, 2.0) as link:
        setup = link.read(Table.HOLDING, 146, 1)[0]
        robot = Robot(lambda at: link.read(Table.INPUT, at, 1)[0], link.write, MonotonicClock().sleep)
        functions = robot.functions()
        functions["tripoint_connect"]("127.0.0.1")
        assert functions["tripoint_latch"](setup, 2000, 5000, False)[0] == 5


def test_a_unit_of_which_the_client_may_not_command_says_so(program: Program, tmp_path: Path) -> None:
    with daemon(tmp_path / "log", "modbus.command_clients=[]") as unit, ModbusLink(unit.address, 2.0) as link:
        plc = Plc(program, Link(link), {**LIMITS, "setup": link.read(Table.HOLDING, 146, 1)[0]})
        until(plc, "live.valid")
        until(plc, "latch_failed", latch=True)
        assert plc.said("latch_result") == 0x0101
        assert plc.said("live.valid")


def test_a_pose_of_a_simulation_is_refused_unless_permitted(plc: Plc) -> None:
    del plc.limits["simulated"]
    until(plc, "alive")
    assert (plc.said("live.valid"), plc.said("live.reason")) == (False, 5)


def test_no_pose_of_a_unit_that_was_stopped_stays_valid(program: Program, tmp_path: Path) -> None:
    clock = MonotonicClock()
    with daemon(tmp_path / "log") as unit, ModbusLink(unit.address, 2.0) as link:
        plc = Plc(program, Link(link), {**LIMITS, "setup": link.read(Table.HOLDING, 146, 1)[0]})
        until(plc, "live.valid")
        unit.process.terminate()
        unit.process.wait(timeout=10.0)
        for _ in range(NEVER):
            plc.cycle(round(clock.now_s() * 1000.0))
            if not plc.said("live.valid"):
                break
        assert plc.said("live.reason") in (2, 8)  # not trusted, or too old
        assert plc.said("live.pose.x_mm") == -2147483.648
