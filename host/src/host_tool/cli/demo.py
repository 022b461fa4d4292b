"""host-tool demo: what `make demo` shows, and its verdict."""

import math

import click
from rich.console import Console

from host_tool.appliance.unit import Unit, open_unit, wait_until_answering
from host_tool.cli.options import Common, common_options
from host_tool.cli.output import number, print_json, terminal
from host_tool.cli.views import view_for
from host_tool.clock import MonotonicClock
from host_tool.demo import SETTLE_S, Verdict, check_simulated, verdict_on
from host_tool.errors import ExitCode
from host_tool.trajectories.paths import SCENARIOS
from host_tool.watching.session import Course, scenes
from host_tool.watching.tally import Summary, Tally
from host_tool.watching.truth import check_comparable

CONNECT_S = 20.0
LINE_S = 1.0


@click.command()
@click.option("--seconds", default=0.0, type=click.FloatRange(min=0.0), help="End after so long; 0: at Ctrl-C.")
@click.option("--scenario", default="paper-circular", show_default=True, type=click.Choice(sorted(SCENARIOS)))
@common_options
def demo(common: Common, seconds: float, scenario: str) -> ExitCode:
    """Measured against truth on a simulated unit, with a verdict at the end."""
    wait_until_answering(common.address, common.timeout_s, CONNECT_S, MonotonicClock())
    course = Course(SCENARIOS[scenario], SETTLE_S, seconds or None)
    console = Console(stderr=True) if common.as_json else terminal()
    with open_unit(common.address, common.timeout_s) as unit:
        check_comparable(unit.identity)
        check_simulated(unit.read_pose())
        summary, p99_ms = _shown(unit, course, console)
    verdict = verdict_on(summary)
    if common.as_json:
        print_json({"summary": summary, "latency_p99_ms": p99_ms, "verdict": verdict})
    else:
        _print(summary, p99_ms, verdict)
    return verdict.exit_code


def _shown(unit: Unit, course: Course, console: Console) -> tuple[Summary, float | None]:
    """Shows until the course or Ctrl-C ends it; the unit, stopped by the same Ctrl-C, is not asked afterwards."""
    summary, p99_us, asked_s = Tally().summary(), None, -math.inf
    try:
        with view_for(console, unit.identity, as_json=False, every_s=LINE_S) as view:
            for scene in scenes(unit, MonotonicClock(), course):
                summary = scene.summary
                view.show(scene)
                if scene.sighting.at_s - asked_s >= LINE_S:
                    p99_us, asked_s = unit.read_health().timing.latency_p99_us, scene.sighting.at_s
    except KeyboardInterrupt:
        click.echo("", err=True)
    return summary, None if p99_us is None else p99_us / 1000.0


def _print(summary: Summary, p99_ms: float | None, verdict: Verdict) -> None:
    click.echo(f"poses            {summary.poses} of {summary.verdicts} verdicts, {summary.missed} missed")
    click.echo(f"rate             {number(summary.rate_hz, 1, 'Hz')}")
    click.echo(f"valid            {_percent(summary.valid_share)}")
    click.echo(f"inside k = 2     {_percent(summary.inside_share)} on all three axes")
    click.echo(f"3D RMS error     {number(summary.rms_mm, 3, 'mm')}, worst {number(summary.worst_mm, 3, 'mm')}")
    click.echo(f"p99 latency      {number(p99_ms, 2, 'ms')} from the later frame to the registers")
    click.echo(f"verdict          {verdict.exit_code.name.lower()}")
    for reason in verdict.reasons:
        click.echo(reason, err=True)


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100.0 * share:.1f} %"
