"""The latch of deploy/plc, run: it keeps to the handshake, and takes no other copy than its own."""

from __future__ import annotations

import pytest
from host.plc_stage import cycles, put, run, staged_plc, wire_of
from structured_text.fake_wire import LATCHED_SEQUENCE
from structured_text.plc import Plc


@pytest.fixture
def plc() -> Plc:
    return staged_plc()


def latched(plc: Plc, limit: int = 60) -> None:
    """Holds the latch input until it is done or has failed."""
    for _ in cycles(plc, limit, latch=True):
        if plc.said("latch_done") or plc.said("latch_failed"):
            return


def test_a_latch_is_0_then_a_word_of_a_new_token_and_gives_the_copy(plc: Plc) -> None:
    run(plc, 12)
    for turn in (1, 2):
        latched(plc)
        assert plc.said("latch_done")
        assert plc.said("latched.valid")
        assert plc.said("latched.sequence") == LATCHED_SEQUENCE
        assert wire_of(plc).written == [0, 0x0101, 0, 0x0102][: 2 * turn]
        run(plc, 3)
        assert not plc.said("latched.valid")


def test_a_latched_pose_grows_old_and_needs_the_same_unit_and_setup(plc: Plc) -> None:
    run(plc, 12)
    latched(plc)
    run(plc, 400, latch=True)
    assert plc.said("latched.valid")
    wire_of(plc).spoil = put(146, "H", 1)
    run(plc, 6, latch=True)
    assert plc.said("latched.reason") == 2
    wire_of(plc).spoil = lambda _: None
    run(plc, 120, latch=True)
    assert plc.said("latched.reason") == 8


def test_a_copy_that_another_client_latched_is_not_taken(plc: Plc) -> None:
    wire_of(plc).latched_sequence = LATCHED_SEQUENCE + 1
    run(plc, 12)
    latched(plc)
    assert plc.said("latch_done")
    assert plc.said("latched.reason") == 2


@pytest.mark.parametrize(
    ("outcome", "refusing", "result"), [((3, 3), False, 3), ((1, 0), False, 0x0100), ((2, 0), True, 0x0101)]
)
def test_a_latch_that_fails_says_why(outcome: tuple[int, int], refusing: bool, result: int, plc: Plc) -> None:
    wire_of(plc).outcome, wire_of(plc).refusing = outcome, refusing
    run(plc, 12)
    latched(plc, limit=250)
    assert (plc.said("latch_failed"), plc.said("latch_result")) == (True, result)
    assert plc.said("live.valid")
    assert not plc.said("latched.valid")


def test_the_outcome_of_an_old_word_is_not_taken_for_the_new_ones(plc: Plc) -> None:
    wire_of(plc).state = wire_of(plc).shown = [0x0101, 2, 0, 99]  # as a PLC finds it that has restarted
    wire_of(plc).lag = 3
    run(plc, 12)
    latched(plc)
    assert plc.said("latch_done")
    assert plc.said("latched.valid")


def test_the_outcome_of_another_clients_word_is_not_taken(plc: Plc) -> None:
    wire_of(plc).rival_word = 0x0155
    run(plc, 12)
    latched(plc, limit=250)
    assert (plc.said("latch_failed"), plc.said("latch_result")) == (True, 0x0100)


def test_a_word_left_from_before_a_restart_starts_nothing(plc: Plc) -> None:
    wire_of(plc).state = [0x0101, 2, 0, 99]
    run(plc, 12)
    latched(plc)
    assert wire_of(plc).written == [0, 0x0101]
    assert plc.said("latched.valid")


def test_a_latch_that_is_given_up_leaves_the_register_to_others(plc: Plc) -> None:
    wire_of(plc).outcome = (1, 0)
    run(plc, 12)
    run(plc, 20, latch=True)
    run(plc, 20)
    written = list(wire_of(plc).written)
    run(plc, 20)
    assert wire_of(plc).written == written == [0, 0x0101]
