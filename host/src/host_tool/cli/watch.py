"""host-tool watch: every verdict as it comes."""

from itertools import islice
from pathlib import Path as FilePath

import click

from host_tool.appliance.unit import open_unit
from host_tool.cli.options import Common, common_options
from host_tool.cli.output import terminal
from host_tool.cli.views import view_for
from host_tool.clock import MonotonicClock
from host_tool.trajectories.paths import SCENARIOS, Path
from host_tool.trajectories.table import path_from_file
from host_tool.watching.session import Course, scenes
from host_tool.watching.truth import check_comparable


@click.command()
@click.option("--count", type=click.IntRange(min=1), help="End after so many lines.")
@click.option("--seconds", type=click.FloatRange(min=0.0, min_open=True), help="End after so long.")
@click.option("--truth", metavar="SCENARIO|CSV", help="Compare with a shipped scenario or a trajectory file.")
@common_options
def watch(common: Common, count: int | None, seconds: float | None, truth: str | None) -> None:
    """Position, uncertainty, age, speed and faults, live; compared with the truth where that is known."""
    path = None if truth is None else truth_from(truth)
    with open_unit(common.address, common.timeout_s) as unit:
        if path is not None:
            check_comparable(unit.identity)
        course = Course(truth=path, seconds=seconds)
        with view_for(terminal(), unit.identity, common.as_json) as view:
            for scene in islice(scenes(unit, MonotonicClock(), course), count):
                view.show(scene)


def truth_from(text: str) -> Path:
    """A scenario by name, else a file; raises UsageError E-TRJ."""
    return SCENARIOS[text] if text in SCENARIOS else path_from_file(FilePath(text))
