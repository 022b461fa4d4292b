"""The Structured Text of deploy/plc, run: it takes exactly the poses that may be used."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import pytest
from blark import transform as tree
from host.plc_stage import (
    CYCLE_MS,
    NO_POSE_MM,
    REFUSALS,
    Spoil,
    clear,
    cycles,
    put,
    raise_bit,
    run,
    staged_plc,
    wire_of,
)
from structured_text.fake_wire import UNKNOWN_32, UNKNOWN_U32
from structured_text.plc import Plc
from structured_text.program import nodes_of
from structured_text.values import Value


@pytest.fixture
def plc() -> Plc:
    return staged_plc()


def test_a_pose_that_may_be_used_is_taken_and_converted(plc: Plc) -> None:
    run(plc, 20)
    assert plc.said("live.valid")
    found = [plc.said(f"live.pose.{name}") for name in ("x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg")]
    assert found == pytest.approx([-12.345, 6.789, 400.001, 10.0, -20.5, 179.999999], abs=1e-9)
    quaternion = [plc.said(f"live.pose.{name}") for name in ("qw", "qx", "qy", "qz")]
    assert quaternion == pytest.approx([0.5, -0.5, 0.5, -0.5], abs=1e-12)
    spread = [plc.said(f"live.pose.uncertainty_{name}") for name in ("x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg")]
    assert spread == pytest.approx([0.12, 0.11, 0.3505, 0.03, 0.04, 0.05], abs=1e-12)


def test_identity_is_asked_once_for_each_connection_and_then_state_and_pose_in_one_request(plc: Plc) -> None:
    run(plc, 40)
    assert plc.asked[0] == (0, 32)
    assert set(plc.asked[1:]) == {(32, 116)}
    wire_of(plc).down = True
    run(plc, 4)
    wire_of(plc).down = False
    before = len(plc.asked)
    run(plc, 10)
    assert (0, 32) in plc.asked[before:]
    assert plc.asked[-1] == (32, 116)


@pytest.mark.parametrize(("spoil", "reason"), [case[1:] for case in REFUSALS], ids=[case[0] for case in REFUSALS])
def test_a_pose_that_may_not_be_used_is_refused_with_its_reason(spoil: Spoil, reason: int, plc: Plc) -> None:
    plc.limits["refused_warnings"] = 1 << 2
    run(plc, 12)
    assert plc.said("live.valid")
    wire_of(plc).spoil = spoil
    run(plc, 8)
    assert (plc.said("live.valid"), plc.said("live.reason")) == (False, reason)
    assert plc.said("live.pose.x_mm") == NO_POSE_MM
    wire_of(plc).spoil = lambda _: None
    run(plc, 8)
    assert plc.said("live.valid")


@pytest.mark.parametrize("limit", ["setup", "age_ms", "uncertainty_mm", "uncertainty_deg"])
def test_a_limit_that_is_not_set_takes_no_pose(limit: str, plc: Plc) -> None:
    del plc.limits[limit]
    run(plc, 20)
    assert plc.said("alive")
    assert not plc.said("live.valid")


def test_registers_that_all_read_0_are_no_setup(plc: Plc) -> None:
    plc.limits["setup"] = 0
    wire_of(plc).spoil = put(146, "H", 0)
    run(plc, 20)
    assert plc.said("live.reason") == 4


@pytest.mark.parametrize(("limit", "value"), [("uncertainty_mm", 1e9), ("uncertainty_deg", 1e9)])
def test_no_limit_is_wide_enough_for_an_unknown_uncertainty(limit: str, value: float, plc: Plc) -> None:
    plc.limits[limit] = value
    wire_of(plc).spoil = put(130 if limit == "uncertainty_mm" else 136, "I", *[UNKNOWN_U32] * 3)
    run(plc, 20)
    assert plc.said("live.reason") == 10


def test_the_position_alone_needs_no_orientation(plc: Plc) -> None:
    plc.limits["orientation"] = False
    wire_of(plc).spoil = lambda image: (clear(3)(image), put(116, "I", *[UNKNOWN_32] * 7)(image))[0]
    run(plc, 20)
    assert plc.said("live.valid")


def test_a_simulated_pose_is_taken_only_where_that_is_permitted(plc: Plc) -> None:
    plc.limits["simulated"] = True
    wire_of(plc).spoil = raise_bit(9)
    run(plc, 20)
    assert plc.said("live.valid")


@pytest.mark.parametrize(
    ("address", "value"), [(0, 0x5451), (1, 2), (3, 999), (4, 0x0201), (5, 0x0403), (6, 0x2000), (7, 0)]
)
def test_a_unit_that_is_not_identified_is_not_trusted(address: int, value: int, plc: Plc) -> None:
    wire_of(plc).spoil = put(address, "H", value)
    run(plc, 20)
    assert not plc.said("identified")
    assert plc.said("live.reason") == 1
    assert {request[0] for request in plc.asked} == {0}


def test_a_heartbeat_that_stands_for_500_ms_is_a_fault_whatever_the_bits_say(plc: Plc) -> None:
    run(plc, 20)
    wire_of(plc).beating = False
    times = [(now_ms, plc.said("alive")) for now_ms in cycles(plc, 80)]
    stopped_ms = next(now_ms for now_ms, alive in times if not alive) - times[0][0]
    assert 480 <= stopped_ms <= 540
    assert plc.said("live.reason") == 2
    wire_of(plc).beating = True
    run(plc, 10)
    assert plc.said("live.valid")


def test_what_comes_back_after_a_silence_is_identified_anew(plc: Plc) -> None:
    run(plc, 20)
    wire_of(plc).beating = False
    run(plc, 60)
    assert plc.asked[-1] == (32, 116)  # no error came, and it was identified once more
    wire_of(plc).beating, wire_of(plc).spoil = True, put(1, "H", 2)
    before = len(plc.asked)
    run(plc, 20)
    assert plc.said("live.valid")  # nothing fell silent in between
    wire_of(plc).beating = False
    run(plc, 60)
    wire_of(plc).beating = True
    run(plc, 20)
    assert (0, 32) in plc.asked[before:]
    assert not plc.said("identified")
    assert plc.said("live.reason") == 2


def test_one_answer_from_a_cache_is_no_heartbeat(plc: Plc) -> None:
    wire_of(plc).beating = False
    run(plc, 40)
    assert plc.said("identified")
    assert not plc.said("alive")


def test_a_pose_grows_old_by_itself_when_no_answer_comes(plc: Plc) -> None:
    run(plc, 20)
    age_ms = plc.said("live.age_ms")
    assert 23.456 < age_ms <= 24 + 2 * CYCLE_MS + 3
    wire_of(plc).down = True
    ages = [(now_ms, plc.said("live.age_ms")) for now_ms in cycles(plc, 10)]
    assert {later[1] - earlier[1] for earlier, later in pairwise(ages)} == {CYCLE_MS}
    assert not plc.said("live.valid")


def test_the_round_trip_counts_as_age() -> None:
    slow = staged_plc()
    for _ in cycles(slow, 20, cycle_ms=200):
        assert not slow.said("live.valid")
    assert slow.said("live.reason") == 8


def test_new_pose_is_said_once_for_each_sequence(plc: Plc) -> None:
    run(plc, 20)
    wire_of(plc).beating = False
    run(plc, 6)
    news = [plc.said("live.new_pose") for _ in cycles(plc, 12)]
    assert plc.said("live.valid")
    assert not any(news)
    wire_of(plc).beating = True
    assert sum(plc.said("live.new_pose") for _ in cycles(plc, 5)) >= 1


def test_these_tests_leave_no_statement_unrun() -> None:
    plc = staged_plc(refused_warnings=1 << 2)
    ways: list[tuple[dict[str, Any], bool]] = [({}, False), ({}, True), ({}, False)]
    ways += [({"spoil": spoil}, False) for _, spoil, _ in REFUSALS] + [({"spoil": put(1, "H", 2), "down": True}, False)]
    ways += [({"down": False, "spoil": lambda _: None}, False), ({"outcome": (3, 3)}, True), ({}, False)]
    ways += [({"refusing": True}, True), ({}, False), ({"refusing": False, "outcome": (1, 0)}, True)]
    ways += [({"beating": False}, False)] * 3
    run(plc, 12)
    for changes, latch in ways:
        for name, value in changes.items():
            setattr(plc.wire, name, value)
        run(plc, 220 if latch and plc.wire.outcome == (1, 0) else 24, latch)  # type: ignore[attr-defined]
    missed = [
        f"{unit.name}: {node}"
        for unit in plc.program.units.values()
        if unit.body is not None
        for node in nodes_of(unit.body)
        if isinstance(node, tree.Statement) and not isinstance(node, tree.CaseElement)
        if id(node) not in plc.runtime.run_nodes
    ]
    assert missed == []


def test_signed_and_unsigned_numbers_reach_both_their_ends(plc: Plc) -> None:
    def result(function: str, number: int) -> int:
        high, low = divmod(number % (1 << 32), 1 << 16)
        inputs = {"high": Value("WORD", high), "low": Value("WORD", low)}
        data: int = plc.runtime.result_of(function, inputs).data
        return data

    for number in (0, 1, 65535, 65536, (1 << 31) - 1, -1, -65536, -65537, -(1 << 31)):
        assert result("TripointSigned", number) == number
    for number in (0, 65536, (1 << 31), (1 << 32) - 1):
        assert result("TripointUnsigned", number) == number
