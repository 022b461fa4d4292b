"""The script for Universal Robots, run against a unit that misbehaves: a pose, or the reason why there is none."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import pytest
from structured_text.fake_wire import SETUP, VALID
from structured_text.urscript import REGISTER_INPUT, SCRIPT, Robot, python_from

from host_tool.contract.register_map import register_map

SEQUENCE = 4711
LIMITS = (SETUP, 2000, 500, True)
NO_POSE_M = -3.2768


@dataclass(slots=True)
class Unit:
    """The registers that the script reads, and the command register."""

    words: dict[int, int] = field(default_factory=dict)
    outcome: tuple[int, int] = (2, SEQUENCE)
    ignores: frozenset[int] = frozenset()
    written: list[int] = field(default_factory=list)
    behind: bool = False  # hands out what was read the time before
    before: dict[int, int] = field(default_factory=dict)
    spoil_copy: dict[int, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.words |= {0: 0x5450, 1: 1, 40: 0, 41: 0, 43: 0, 1000: 0}

    def read(self, address: int) -> int:
        value = self.words.get(address, 0)
        if self.behind and address >= 448:
            value, self.before[address] = self.before.get(address, 0), value
        return value

    def write(self, address: int, value: int) -> None:
        assert address == 1000
        self.written.append(value)
        if value in self.ignores:
            return
        state, detail = self.outcome if value else (0, 0)
        self.words |= {40: value, 41: state, 43: detail}
        if state == 2:
            copy = dict.fromkeys(range(448, 464), 0)
            copy |= {448: SEQUENCE, 449: VALID, 452: 1234, 453: 65536 - 679, 454: 4001, 455: 31415, 456: 65535, 457: 0}
            copy |= {458: 120, 459: 110, 460: 350, 461: 40, 462: SETUP, 463: SEQUENCE}
            self.words |= copy | self.spoil_copy


def latch(unit: Unit, *limits: Any) -> list[float]:
    robot = Robot(unit.read, unit.write, lambda _: None)
    functions = robot.functions()
    functions["tripoint_connect"]("192.168.1.20")
    found: list[float] = functions["tripoint_latch"](*(limits or LIMITS))
    return found


def test_a_latched_pose_is_read_in_m_and_rad() -> None:
    for behind in (False, True):
        unit = Unit(behind=behind)
        assert latch(unit) == pytest.approx([0, 0.1234, -0.0679, 0.4001, 3.1415, -0.0001, 0.0])
        assert unit.written == [0, 0x0101]


def test_each_latch_takes_another_token() -> None:
    unit = Unit()
    for _ in range(3):
        latch(unit)
    assert unit.written == [0, 0x0101, 0, 0x0102, 0, 0x0103]
    unit.words[40] = 0x01FF
    latch(unit)
    assert unit.written[-1] == 0x0101


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        ({463: 1}, 3),
        ({448: 1, 463: 1}, 3),
        ({462: 1}, 4),
        ({449: VALID | 1 << 9}, 5),
        ({449: VALID & ~(1 << 2)}, 6),
        ({449: VALID & ~(1 << 3)}, 6),
        ({449: VALID | 1 << 4}, 6),
        ({452: 32768}, 6),
        ({455: 32768}, 6),
        ({449: VALID & ~(1 << 13)}, 7),
        ({449: VALID & ~(1 << 14)}, 7),
        ({461: 2001}, 8),
        ({458: 501}, 10),
        ({460: 501}, 10),
    ],
)
def test_a_copy_that_may_not_be_used_is_refused_with_its_reason(spoil: dict[int, int], reason: int) -> None:
    assert latch(Unit(spoil_copy=spoil)) == [reason, NO_POSE_M, NO_POSE_M, NO_POSE_M, 0, 0, 0]


@pytest.mark.parametrize(("limits", "reason"), [((SETUP, 65535, 500, True), 8), ((SETUP, 2000, 65535, True), 10)])
def test_no_limit_is_wide_enough_for_an_unknown(limits: tuple[Any, ...], reason: int) -> None:
    assert latch(Unit(spoil_copy={461 if reason == 8 else 459: 65535}), *limits)[0] == reason


def test_registers_that_all_read_0_are_no_setup() -> None:
    assert latch(Unit(spoil_copy={462: 0}), 0, 2000, 500, False)[0] == 4


@pytest.mark.parametrize(
    ("unit", "reason"),
    [
        (Unit(outcome=(3, 0)), 11),
        (Unit(outcome=(1, 0)), 12),
        (Unit(ignores=frozenset({0x0101})), 12),
    ],
)
def test_a_latch_that_fails_says_why(unit: Unit, reason: int) -> None:
    assert latch(unit)[0] == reason


def test_a_unit_that_takes_no_word_of_this_robot_says_so() -> None:
    unit = Unit(ignores=frozenset({0}))
    unit.words[40] = 0x0107
    assert latch(unit)[0] == 12


@pytest.mark.parametrize(("address", "value"), [(0, 0), (1, 2)])
def test_what_is_no_tripoint_is_never_commanded(address: int, value: int) -> None:
    unit = Unit()
    unit.words[address] = value
    assert latch(unit)[0] == 2
    assert unit.written == []


def test_the_signals_are_the_registers_of_their_names() -> None:
    robot = Robot(lambda _: 0, lambda *_: None, lambda _: None)
    robot.functions()["tripoint_connect"]("192.168.1.20")
    blocks = register_map().blocks
    named = {f"tp_{name}": one.address for name, one in blocks["latched_single"].registers.items()}
    named |= {f"tp_{name}": one.address for name, one in blocks["identity"].registers.items()}
    named |= {
        f"tp_{name}": one.address for name, one in blocks["state"].registers.items() if name.startswith("command_")
    }
    named |= {"tp_echo": blocks["state"].registers["command_echo"].address, "tp_command": blocks["command"].first}
    named |= {
        f"tp_{name}": blocks["latched_single"].registers[name].address for name in ("sequence", "status", "setup")
    }
    for name, (address, kind) in robot.signals.items():
        assert address == named[name], name
        assert (kind == REGISTER_INPUT) is (name != "tp_command")
    assert robot.frequencies == dict.fromkeys(robot.signals, 0)


@pytest.mark.parametrize(
    ("spoil", "complaint"),
    [
        (lambda text: text.replace("\nend\n", "\n", 1), "indented by 0, not 2|closes no block|have no end"),
        (lambda text: text + "end\n", "closes no block"),
        (lambda text: re.sub(r"\n  end\n", "\n    end\n", text, count=1), "closes no block"),
    ],
)
def test_a_block_that_is_not_closed_is_refused(spoil: Callable[[str], str], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        python_from(spoil(SCRIPT.read_text(encoding="utf-8")))
