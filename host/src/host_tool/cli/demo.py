"""host-tool demo: what `make demo` shows, and its verdict."""

import math
from dataclasses import dataclass

import click
from rich.console import Console

from host_tool.appliance.unit import Unit, open_unit, wait_until_answering
from host_tool.cli.options import Common, Finite, common_options
from host_tool.cli.output import number, print_json, terminal
from host_tool.cli.views import view_for
from host_tool.clock import MonotonicClock
from host_tool.demo import SETTLE_S, Verdict, check_simulated, exit_code_of, verdict_on
from host_tool.errors import ExitCode
from host_tool.trajectories.paths import SCENARIOS
from host_tool.watching.session import Course, scenes
from host_tool.watching.tally import Summary, Tally
from host_tool.watching.truth import check_comparable

CONNECT_S = 20.0
LINE_S = 1.0


@dataclass(frozen=True, slots=True)
class Seen:
    """What a run has shown: from the end of settling on, and in whole; the latency as the unit last told it."""

    settled: Summary
    whole: Summary
    p99_ms: float | None


@click.command(epilog="Example: host-tool demo --seconds 20 --json")
@click.option(
    "--seconds", default=0.0, type=Finite(min=0.0), metavar="SECONDS", help="End after so long.  [default: at Ctrl-C]"
)
@click.option(
    "--scenario",
    default="paper-circular",
    show_default=True,
    type=click.Choice(sorted(SCENARIOS)),
    metavar="SCENARIO",
    help="What the simulated target of the unit runs: paper-circular, paper-linear, scout, static-volume "
    "or bumped-camera.",
)
@common_options
def demo(common: Common, seconds: float, scenario: str) -> ExitCode:
    """Show measured against truth on a simulated unit.

    Waits up to 20 s for the unit. The figures count from 5 s on; the verdict is pass (exit 0), failed (exit 1) or
    inconclusive (exit 4; exit 0 where Ctrl-C is the only end).
    """
    wait_until_answering(common.address, common.timeout_s, CONNECT_S, MonotonicClock())
    course = Course(SCENARIOS[scenario], SETTLE_S, seconds or None)
    console = Console(stderr=True) if common.as_json else terminal()
    with open_unit(common.address, common.timeout_s) as unit:
        check_comparable(unit.identity)
        check_simulated(unit.read_pose())
        seen = _shown(unit, course, console)
    verdict = verdict_on(seen.settled)
    if common.as_json:
        print_json({"summary": seen.settled, "latency_p99_ms": seen.p99_ms, "verdict": verdict})
    else:
        _print(seen, verdict)
    return exit_code_of(verdict, endless=course.seconds is None)


def _shown(unit: Unit, course: Course, console: Console) -> Seen:
    """Shows until the course or Ctrl-C ends it; the unit, stopped by the same Ctrl-C, is not asked afterwards."""
    settled, whole, p99_us, asked_s = Tally().summary(), Tally(), None, -math.inf
    try:
        with view_for(console, unit.identity, as_json=False, every_s=LINE_S) as view:
            for scene in scenes(unit, MonotonicClock(), course):
                settled = scene.summary
                whole.add(scene.sighting, scene.comparison)
                view.show(scene)
                if scene.sighting.at_s - asked_s >= LINE_S:
                    p99_us, asked_s = unit.read_health().timing.latency_p99_us, scene.sighting.at_s
    except KeyboardInterrupt:
        click.echo("", err=True)
    return Seen(settled, whole.summary(), None if p99_us is None else p99_us / 1000.0)


def _print(seen: Seen, verdict: Verdict) -> None:
    """The figures that the verdict is about; when it could not be given, those of the whole run."""
    inconclusive = verdict.exit_code is ExitCode.INCONCLUSIVE
    summary = seen.whole if inconclusive else seen.settled
    click.echo(f"poses            {summary.poses} of {summary.verdicts} verdicts, {summary.missed} missed")
    click.echo(f"rate             {number(summary.rate_hz, 1, 'Hz')}")
    click.echo(f"valid            {_percent(summary.valid_share)}")
    click.echo(f"inside k = 2     {_percent(summary.inside_share)} on all three axes")
    click.echo(f"3D RMS error     {number(summary.rms_mm, 3, 'mm')}, worst {number(summary.worst_mm, 3, 'mm')}")
    if summary.turned_rms_deg is not None:
        worst = number(summary.turned_worst_deg, 3, "degrees")
        click.echo(f"turned by        {number(summary.turned_rms_deg, 3, 'degrees')} RMS, worst {worst}")
    click.echo(f"p99 latency      {number(seen.p99_ms, 2, 'ms')} from the later frame to the registers")
    if inconclusive:
        click.echo(
            f"counted          from the first moment on, while cameras and clocks still settle for {SETTLE_S:g} s"
        )
    why = f": {', '.join(verdict.reasons)}" if verdict.reasons else ""
    click.echo(f"verdict          {verdict.exit_code.name.lower()}{why}")


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100.0 * share:.1f} %"
