"""What `tripoint-render` is asked to draw is what `tripointd replay` then measures."""

import json
import math
import statistics
import subprocess
from itertools import combinations
from pathlib import Path
from typing import Any

from system.daemon import CONFIG, finished, renderer

FRAMES = 40
WITHIN_MM = 1.0  # of a side: the depth of an LED is stated to 0.8 mm (k = 2), and the sides lie across


def replayed(folder: Path, *scene: str) -> list[dict[str, Any]]:
    """The verdicts on a target that stands still 400 mm away."""
    folder.mkdir()
    still = folder / "still.csv"
    rows = "".join(f"{t_s},-60,20,400,0,1,0,0\n" for t_s in (0, 1))
    still.write_text("t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n" + rows, encoding="utf-8")
    options = ("--frames", str(FRAMES), "--trajectory", str(still), *scene)
    subprocess.run([renderer(), *options, "--out", str(folder / "recording")], check=True, timeout=60.0)
    calibration = ("--calibration", str(CONFIG.parent / "calibration.toml"), "--config", str(CONFIG))
    run = finished("replay", str(folder / "recording"), *calibration, "--json", limit_s=60.0)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


def test_a_target_is_drawn_larger(tmp_path: Path) -> None:
    last = replayed(tmp_path / "larger", "--leds", "3", "--target-scale", "1.5")[-1]
    places = [point["position_mm"] for point in last["points"]]
    sides_mm = sorted(math.dist(one, other) for one, other in combinations(places, 2))
    assert len(sides_mm) == 3
    assert all(abs(side - nominal) < WITHIN_MM for side, nominal in zip(sides_mm, (90.0, 120.0, 150.0), strict=True))


def test_a_noisier_sensor_scatters_more(tmp_path: Path) -> None:
    """Ten times the read noise: less than ten times the scatter, because light is noisy by itself."""
    scatters_mm = []
    for noise in ("0.002", "0.02"):
        verdicts = replayed(tmp_path / noise, "--read-noise", noise)
        scatters_mm.append(statistics.stdev(one["position_mm"][2] for one in verdicts if one["valid"]))
    assert 2.0 * scatters_mm[0] < scatters_mm[1] < 10.0 * scatters_mm[0]
