"""The scenario bumped-camera from its pictures: the fault comes with the knock and goes with it, by target or datum."""

import json
import subprocess
from pathlib import Path
from typing import Any

from system.daemon import CONFIG, finished, renderer

ROUND_S = 12.0
RATE = 15
NOTICED_S, CLEARED_S = 2.0, 6.0  # fifteen views a second


DATUM_NOTICED_S = 4.0  # its spots are weak, and a knock of 0.1 degrees is barely more than they may err
DATUM_MM = (-120.0, 110.0, 620.0)
DATUM = """
[datum]
position_mm = [-120, 110, 620]
uncertainty_mm = 0.2
radius_mm = 20
"""


class Replayed:
    """Three rounds of a motion; in the second the right camera stands turned."""

    def __init__(self, folder: Path, scene: tuple[str, ...], known: tuple[str, ...]) -> None:
        motion = ("--scenario", "bumped-camera", "--frames", str(int(3 * ROUND_S * RATE)), "--format", "jpg")
        subprocess.run([renderer(), *motion, *scene, "--out", str(folder / "recording")], check=True, timeout=120.0)
        calibration = ("--calibration", str(CONFIG.parent / "calibration.toml"))
        run = finished("replay", str(folder / "recording"), *calibration, *known, limit_s=120.0)
        assert run.returncode == 0, run.stderr
        self.verdicts: list[dict[str, Any]] = [json.loads(line) for line in run.stdout.splitlines()]

    def between(self, first_s: float, last_s: float) -> list[dict[str, Any]]:
        found = [one for one in self.verdicts if first_s <= one["t_ns"] * 1e-9 % (3 * ROUND_S) < last_s]
        assert len(found) > RATE
        return found


def test_a_knock_takes_the_pose_until_the_camera_is_put_back(tmp_path: Path) -> None:
    known = ("--target", str(CONFIG.parent / "target.toml"), "--config", str(CONFIG))
    replayed = Replayed(tmp_path, ("--leds", "3"), known)
    upright = replayed.between(0.5, ROUND_S - 0.1) + replayed.between(2 * ROUND_S + CLEARED_S, 3 * ROUND_S)
    knocked = replayed.between(ROUND_S + NOTICED_S, 2 * ROUND_S)
    assert not any("decalibration" in one["faults"] for one in upright)
    assert sum(one["orientation_valid"] for one in upright) > 0.9 * len(upright)
    assert all("decalibration" in one["faults"] and not one["valid"] for one in knocked)
    assert not any(one["mount_watched"] for one in replayed.verdicts)


def test_a_datum_shows_the_knock_beside_a_single_led(tmp_path: Path) -> None:
    config = tmp_path / "datum.toml"
    config.write_text(CONFIG.read_text() + DATUM)
    replayed = Replayed(tmp_path, ("--datum", *map(str, DATUM_MM)), ("--config", str(config)))
    upright = replayed.between(1.0, ROUND_S - 0.1) + replayed.between(2 * ROUND_S + CLEARED_S, 3 * ROUND_S)
    knocked = replayed.between(ROUND_S + DATUM_NOTICED_S, 2 * ROUND_S)
    assert not any("decalibration" in one["faults"] for one in upright)
    assert sum(one["valid"] and one["mount_watched"] for one in upright) > 0.9 * len(upright)
    assert all("decalibration" in one["faults"] and not one["valid"] for one in knocked)
    assert not any(one["mount_watched"] for one in knocked)
