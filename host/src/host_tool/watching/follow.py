"""Following a unit: every verdict once, and honestly how many were missed between two reads."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from host_tool.clock import Clock
from host_tool.contract.blocks import Answer

_SEQUENCES = 1 << 32  # the counter wraps
POLL_S = 0.003  # free-running cameras bring verdicts in pairs a few ms apart; each shall be seen
SILENCE_S = 0.5  # a heartbeat unchanged for so long is a communication fault


class Source(Protocol):
    """What can be followed: a unit, or in tests a list of answers."""

    def read_pose(self) -> Answer: ...


@dataclass(frozen=True, slots=True)
class Sighting:
    """One answer worth showing."""

    answer: Answer
    at_s: float  # on the clock passed in
    fresh: bool  # False: nothing new for SILENCE_S, shown so that a hang is seen
    missed: int  # verdicts between this and the sighting before


def missed_between(before: int | None, now: int) -> int:
    """Sequence numbers skipped from one sighting to the next; a restart of the unit counts as none."""
    if before is None:
        return 0
    step = (now - before) % _SEQUENCES
    return step - 1 if 0 < step < _SEQUENCES // 2 else 0


def follow(source: Source, clock: Clock, seconds: float | None = None) -> Iterator[Sighting]:
    """Yields each new verdict once, and a repeat every SILENCE_S while none comes; ends after `seconds`."""
    start_s = shown_s = clock.now_s()
    last: int | None = None
    while seconds is None or clock.now_s() - start_s < seconds:
        answer, asked_s = source.read_pose(), clock.now_s()
        fresh = answer.pose.sequence != last
        if fresh or asked_s - shown_s >= SILENCE_S:
            yield Sighting(answer, asked_s, fresh, missed_between(last, answer.pose.sequence) if fresh else 0)
            last, shown_s = answer.pose.sequence, asked_s
        clock.sleep(max(0.0, POLL_S - (clock.now_s() - asked_s)))
