"""host-tool simulate: a shipped scenario as a trajectory file."""

from pathlib import Path as FilePath

import click

from host_tool.cli.options import Common, Finite, common_options
from host_tool.cli.output import print_json
from host_tool.errors import UsageError
from host_tool.trajectories.paths import SCENARIOS, scenario_from
from host_tool.trajectories.table import lines_of


@click.command(epilog="Example: host-tool simulate paper-circular --rate 50 --out circle.csv")
@click.argument("scenario", metavar="SCENARIO", type=click.Choice(sorted(SCENARIOS)))
@click.option(
    "--rate", default=100.0, show_default=True, type=Finite(0.1, 10000.0), metavar="HZ", help="Rows per second."
)
@click.option("--seconds", type=Finite(0.1, 3600.0), metavar="SECONDS", help="Length.  [default: one period]")
@click.option("--out", type=click.Path(path_type=FilePath, dir_okay=False), help="File to write.  [default: stdout]")
@common_options
def simulate(common: Common, scenario: str, rate: float, seconds: float | None, out: FilePath | None) -> None:
    """Write the path of a scenario as CSV.

    SCENARIO is paper-circular (half a circle and back in 12 s), paper-linear (a line and back in 12 s), scout
    (the path of a mobile robot's arm and back in 6 s), static-volume (27 places, 3 s each) or bumped-camera
    (paper-circular three times). Columns: t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz, the target in the reference frame. No unit
    is asked.
    """
    path = scenario_from(scenario)
    lines = list(lines_of(path, rate, seconds or path.period_s))
    if out is not None:
        _write(out, lines)
    elif not common.as_json:
        click.echo("\n".join(lines))
    if common.as_json:
        rows = [[float(cell) for cell in line.split(",")] for line in lines[1:]] if out is None else len(lines) - 1
        print_json({"scenario": scenario, "period_s": path.period_s, "file": out and str(out), "rows": rows})


def _write(file: FilePath, lines: list[str]) -> None:
    try:
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    except OSError as error:
        raise UsageError("E-TRJ-06", f"cannot write {file} ({error.strerror})", "choose another --out") from error
