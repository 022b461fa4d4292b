"""One following of a unit from start to end: each sighting with its truth, its speed and the figures so far."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from host_tool.clock import Clock
from host_tool.contract.blocks import Health
from host_tool.trajectories.paths import Path
from host_tool.watching.follow import Sighting, Source, follow
from host_tool.watching.speed import Speedometer
from host_tool.watching.tally import Summary, Tally
from host_tool.watching.truth import Comparison, compared

HEALTH_S = 0.5  # cameras and timing are asked for this often: they change slowly


class Unit(Source, Protocol):
    """What can be followed with the health of its cameras."""

    def read_health(self) -> Health: ...


@dataclass(frozen=True, slots=True)
class Course:
    """What to compare with, when the figures begin to count, and when to end (None: never)."""

    truth: Path | None = None
    settle_s: float = 0.0
    seconds: float | None = None


@dataclass(frozen=True, slots=True)
class Scene:
    """Everything that is known at one sighting."""

    sighting: Sighting
    comparison: Comparison | None
    speed_mm_per_s: float | None
    without_s: float | None  # how long this following has seen no valid position; None while there is one
    summary: Summary  # from the end of settling on
    health: Health  # at most HEALTH_S old


def scenes(source: Unit, clock: Clock, course: Course) -> Iterator[Scene]:
    """Follows to the end of the course."""
    tally, speedometer, start_s = Tally(), Speedometer(), clock.now_s()
    lost_s: float | None = None
    health, asked_s = source.read_health(), start_s
    for sighting in follow(source, clock, course.seconds):
        pose = sighting.answer.pose
        comparison = None if course.truth is None else compared(pose, course.truth)
        if sighting.at_s - start_s >= course.settle_s:
            tally.add(sighting, comparison)
        if pose.position_valid:
            lost_s = None
        elif lost_s is None:
            lost_s = sighting.at_s
        without_s = None if lost_s is None else sighting.at_s - lost_s
        if sighting.at_s - asked_s >= HEALTH_S:
            health, asked_s = source.read_health(), sighting.at_s
        yield Scene(sighting, comparison, speedometer.take(pose), without_s, tally.summary(), health)
