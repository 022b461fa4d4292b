"""host-tool watch: every verdict as it comes."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path as FilePath

import click

from host_tool.appliance.unit import open_unit
from host_tool.cli.options import Common, Finite, common_options
from host_tool.cli.output import terminal
from host_tool.cli.views import view_for
from host_tool.clock import MonotonicClock
from host_tool.contract.conditions import Status
from host_tool.trajectories.paths import SCENARIOS, Path
from host_tool.trajectories.table import path_from_file
from host_tool.watching.session import Course, scenes
from host_tool.watching.truth import check_comparable, check_scenario_on


@click.command(epilog="Example: host-tool watch --seconds 10 --json --device 192.168.1.20:502 > poses.jsonl")
@click.option(
    "--count", type=click.IntRange(min=1), metavar="N", help="End after so many verdicts.  [default: at Ctrl-C]"
)
@click.option(
    "--seconds", type=Finite(min=0.0, min_open=True), metavar="SECONDS", help="End after so long.  [default: at Ctrl-C]"
)
@click.option(
    "--truth",
    metavar="SCENARIO|CSV",
    help="Where the target truly is: what a simulated unit runs (paper-circular, paper-linear, scout, static-volume, "
    "bumped-camera), "
    "or a CSV as host-tool simulate writes it; time is UTC modulo its length.",
)
@common_options
def watch(common: Common, count: int | None, seconds: float | None, truth: str | None) -> None:
    """Show every verdict of the unit as it comes.

    Position, expanded uncertainty (k = 2), age, speed and faults: a live picture in a terminal, else a line each.
    With --truth also the true position and the error. Lengths are mm, times UTC.
    """
    path = None if truth is None else truth_from(truth)
    with open_unit(common.address, common.timeout_s) as unit:
        if path is not None:
            check_comparable(unit.identity)
        if truth in SCENARIOS:
            check_scenario_on(bool(unit.read_pose().state.status & Status.SIMULATED))
        course = Course(truth=path, seconds=seconds)
        with endable(by_ctrl_c=not (count or seconds)), view_for(terminal(), unit.identity, common.as_json) as view:
            for scene in islice(scenes(unit, MonotonicClock(), course), count):
                view.show(scene)


@contextmanager
def endable(by_ctrl_c: bool) -> Iterator[None]:
    """Ctrl-C is how a following without an end ends: well, not interrupted."""
    try:
        yield
    except KeyboardInterrupt:
        if not by_ctrl_c:
            raise


def truth_from(text: str) -> Path:
    """A scenario by name, else a file; raises UsageError E-TRJ."""
    return SCENARIOS[text] if text in SCENARIOS else path_from_file(FilePath(text))
