"""host-tool simulate: a shipped scenario as a trajectory file."""

from pathlib import Path as FilePath

import click

from host_tool.cli.options import Common, common_options
from host_tool.cli.output import print_json
from host_tool.errors import UsageError
from host_tool.trajectories.paths import SCENARIOS, scenario_from
from host_tool.trajectories.table import lines_of


@click.command()
@click.argument("scenario", type=click.Choice(sorted(SCENARIOS)))
@click.option("--rate", default=100.0, show_default=True, type=click.FloatRange(0.1, 10000.0), help="Rows per second.")
@click.option("--seconds", type=click.FloatRange(0.1, 3600.0), help="Length; default one period.")
@click.option("--out", type=click.Path(path_type=FilePath, dir_okay=False), help="File; default stdout.")
@common_options
def simulate(common: Common, scenario: str, rate: float, seconds: float | None, out: FilePath | None) -> None:
    """Write the trajectory of SCENARIO as CSV: t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz in the reference frame."""
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
