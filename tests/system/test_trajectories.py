"""The unit's simulation and host-tool's truth are one closed form, written twice: here they are compared."""

import csv
import subprocess
from pathlib import Path

import pytest
from system.daemon import renderer

from host_tool.trajectories.paths import SCENARIOS

FRAMES = 37  # no divisor of the scenarios' turning points
ROUNDING_MM = 1e-6  # the file has six digits


@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_the_simulation_renders_the_path_that_host_tool_calls_true(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "recording"
    small = ("--frames", str(FRAMES), "--width", "320", "--height", "240")
    subprocess.run([renderer(), *small, "--scenario", name, "--out", str(folder)], check=True, timeout=60.0)
    with (folder / "truth.csv").open(newline="", encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == FRAMES
    for row in rows:
        utc_ns = round(float(row["t_s"]) * 1e9)
        rendered_mm = [float(row[column]) for column in ("x_mm", "y_mm", "z_mm")]
        assert rendered_mm == pytest.approx(SCENARIOS[name].position_at_utc_mm(utc_ns), abs=ROUNDING_MM)
        assert [float(row[column]) for column in ("qw", "qx", "qy", "qz")] == [0.0, 1.0, 0.0, 0.0]
