"""Ways to show what is followed: JSON lines, plain lines, or a picture that is redrawn in place."""

import math
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

import click
from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from host_tool.cli.exposure import margins_of
from host_tool.cli.output import is_live, number, print_json
from host_tool.cli.wording import age_of, conditions_of, line_of, position_of, record_of, time_of
from host_tool.contract.blocks import Identity, Pose
from host_tool.contract.conditions import Status
from host_tool.watching.session import Scene
from host_tool.watching.tally import Summary

BARS = "▁▂▃▄▅▆▇█"
HISTORY = 50  # columns of the sparkline; with its name and maximum it fits the panel
REDRAW_S = 0.1


class View(Protocol):
    """One way to show."""

    def show(self, scene: Scene) -> None: ...


class JsonLines:
    """For programs: every verdict."""

    def show(self, scene: Scene) -> None:
        print_json(record_of(scene))


class PlainLines:
    """For logs and pipes: every verdict, or one in `every_s`."""

    def __init__(self, console: Console, every_s: float = 0.0) -> None:
        self._console = console
        self._every_s = every_s
        self._next_s: float | None = None

    def show(self, scene: Scene) -> None:
        at_s = scene.sighting.at_s
        if self._next_s is not None and at_s < self._next_s:
            return
        self._next_s = at_s + self._every_s
        click.echo(line_of(scene), file=self._console.file)


class Picture:
    """For people in a terminal."""

    def __init__(self, live: Live, title: str) -> None:
        self._live = live
        self._title = title
        self._drawn_s = -math.inf
        self._history: deque[float] = deque(maxlen=HISTORY)

    def show(self, scene: Scene) -> None:
        if scene.comparison is not None:
            self._history.append(scene.comparison.error_mm)
        elif scene.speed_mm_per_s is not None:
            self._history.append(scene.speed_mm_per_s)
        if scene.sighting.at_s - self._drawn_s >= REDRAW_S:  # drawing takes longer than asking: not for every verdict
            self._live.update(picture_of(scene, self._title, tuple(self._history)), refresh=True)
            self._drawn_s = scene.sighting.at_s


@contextmanager
def view_for(console: Console, identity: Identity, as_json: bool, every_s: float = 0.0) -> Iterator[View]:
    """The way that suits where the output goes."""
    if as_json:
        yield JsonLines()
    elif is_live(console):
        title = f"Tripoint {identity.serial_number}  {identity.mode.replace('_', ' ')}"
        with Live(console=console, auto_refresh=False) as live:
            yield Picture(live, title)
    else:
        yield PlainLines(console, every_s)


def picture_of(scene: Scene, title: str, history: tuple[float, ...]) -> RenderableType:
    """One redraw."""
    pose = scene.sighting.answer.pose
    simulated = "  SIMULATED" if pose.status & Status.SIMULATED else ""
    parts: list[RenderableType] = [_axes(pose, scene), Text(_figures(scene)), *_history_rows(scene, history)]
    for kind, condition in conditions_of(scene.sighting.answer):
        style = "bold red" if kind == "fault" else "yellow"
        parts.append(Text(f"{kind}: {condition.words}: {condition.remedy}", style=style, no_wrap=False))
    return Panel(Group(*parts), title=f"{title}{simulated}", title_align="left", width=78)


def sparkline(values: tuple[float, ...]) -> str:
    """Values from 0 to their largest as bars; empty for none."""
    top = max(values, default=0.0)
    if top <= 0.0:
        return BARS[0] * len(values)
    return "".join(BARS[min(len(BARS) - 1, int(value / top * len(BARS)))] for value in values)


def _axes(pose: Pose, scene: Scene) -> RenderableType:
    if pose.position_mm is None or pose.uncertainty_mm is None or not pose.position_valid:
        return Text(position_of(pose, scene.without_s), style="bold red")
    table = Table(box=None, padding=(0, 2))
    headings = ("", "measured", "± (k=2)", "truth", "error")
    for heading in headings if scene.comparison is not None else headings[:3]:
        table.add_column(heading, justify="right")
    for axis, (value, spread) in enumerate(zip(pose.position_mm, pose.uncertainty_mm, strict=True)):
        cells = [f"{'xyz'[axis]} mm", number(value, 3), number(spread, 3)]
        if scene.comparison is None:
            table.add_row(*cells)
            continue
        truth = scene.comparison.truth_mm[axis]
        style = "green" if abs(value - truth) <= spread else "yellow"
        table.add_row(*cells, number(truth, 3), Text(number(value - truth, 3), style=style))
    if pose.orientation_valid and pose.angles_deg is not None:
        spreads_deg = pose.uncertainty_deg or (None, None, None)  # absent in gimbal lock
        for name, angle_deg, spread_deg in zip("ABC", pose.angles_deg, spreads_deg, strict=True):
            table.add_row(f"{name} deg", number(angle_deg, 3), number(spread_deg, 3))
    return table


def _figures(scene: Scene) -> str:
    pose = scene.sighting.answer.pose
    lines = [
        f"exposed {time_of(pose.exposed_utc_ns)} UTC   age {age_of(pose)}   "
        f"speed {number(scene.speed_mm_per_s, 0, 'mm/s')}   #{pose.sequence}",
        *_turned(scene),
        _counted(scene.summary),
        *margins_of(scene.health),
    ]
    if not scene.sighting.fresh:
        lines.append("NOTHING NEW: the unit has stopped bringing verdicts")
    return "\n".join(lines)


def _turned(scene: Scene) -> list[str]:
    if scene.comparison is None or scene.comparison.turned_deg is None:
        return []
    return [f"turned by {scene.comparison.turned_deg:.3f} degrees from the truth"]


def _counted(summary: Summary) -> str:
    if summary.verdicts == 0:
        return "settling: not counted yet"
    rate = number(summary.rate_hz, 1, "Hz")
    return f"{rate}   {summary.poses} poses of {summary.verdicts} verdicts, {summary.missed} missed"


def _history_rows(scene: Scene, history: tuple[float, ...]) -> list[Text]:
    if not history:
        return []
    name, unit = ("error", "mm") if scene.comparison is not None else ("speed", "mm/s")
    return [Text(f"{name} {sparkline(history)} max {max(history):.3g} {unit}", style="cyan")]
