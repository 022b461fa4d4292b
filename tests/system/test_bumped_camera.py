"""The scenario bumped-camera from its pictures: the fault comes with the knock and goes with it."""

import json
import subprocess
from pathlib import Path
from typing import Any

from system.daemon import CONFIG, finished, renderer

ROUND_S = 12.0
RATE = 15
NOTICED_S, CLEARED_S = 2.0, 6.0  # fifteen views a second


def test_a_knock_takes_the_pose_until_the_camera_is_put_back(tmp_path: Path) -> None:
    frames = str(int(3 * ROUND_S * RATE))
    scene = ("--scenario", "bumped-camera", "--leds", "3", "--frames", frames, "--format", "jpg")
    subprocess.run([renderer(), *scene, "--out", str(tmp_path / "recording")], check=True, timeout=120.0)
    known = ("--calibration", str(CONFIG.parent / "calibration.toml"), "--target", str(CONFIG.parent / "target.toml"))
    run = finished("replay", str(tmp_path / "recording"), *known, "--config", str(CONFIG), limit_s=120.0)
    assert run.returncode == 0, run.stderr
    verdicts: list[dict[str, Any]] = [json.loads(line) for line in run.stdout.splitlines()]

    def between(first_s: float, last_s: float) -> list[dict[str, Any]]:
        found = [one for one in verdicts if first_s <= one["t_ns"] * 1e-9 % (3 * ROUND_S) < last_s]
        assert len(found) > RATE
        return found

    upright = between(0.5, ROUND_S - 0.1) + between(2 * ROUND_S + CLEARED_S, 3 * ROUND_S)
    knocked = between(ROUND_S + NOTICED_S, 2 * ROUND_S)
    assert not any("decalibration" in one["faults"] for one in upright)
    assert sum(one["orientation_valid"] for one in upright) > 0.9 * len(upright)
    assert all("decalibration" in one["faults"] and not one["valid"] for one in knocked)
