"""Three LEDs, rendered while they move and turn, measured from the pictures: position and orientation against truth."""

import json
import subprocess
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from system.daemon import CONFIG, finished, renderer

Floats = NDArray[np.float64]

PERIOD_S = 2.0
PICTURES = 50
CHI2_6_AT_999 = 22.46


def turn(axis: int, angle_rad: float) -> Floats:
    """Quaternion w, x, y, z of a turn about one axis."""
    quaternion = np.zeros(4)
    quaternion[0], quaternion[1 + axis] = np.cos(angle_rad / 2.0), np.sin(angle_rad / 2.0)
    return quaternion


def product(a: Floats, b: Floats) -> Floats:
    vector = a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])
    return np.array([a[0] * b[0] - a[1:] @ b[1:], *vector])


def position_mm(t_s: float) -> Floats:
    phase = 2.0 * np.pi * t_s / PERIOD_S
    return np.array([-20.0 + 15.0 * np.cos(phase), 10.0 + 15.0 * np.sin(phase), 400.0 + 5.0 * np.sin(phase)])


def attitude(t_s: float) -> Floats:
    phase = 2.0 * np.pi * t_s / PERIOD_S
    tilted = product(turn(1, 0.3 + 0.1 * np.cos(phase)), turn(0, np.pi - 0.2))
    return product(tilted, turn(2, 0.4 * np.sin(phase)))


def error_of(verdict: dict[str, Any]) -> Floats:
    """Position, mm, and rotation vector, rad, in the output frame: measured minus true."""
    t_s = verdict["t_ns"] * 1e-9 % PERIOD_S
    inverse = attitude(t_s) * np.array([1.0, -1.0, -1.0, -1.0])
    between = product(np.array(verdict["quaternion_wxyz"]), inverse)
    return np.concatenate(
        [np.array(verdict["position_mm"]) - position_mm(t_s), 2.0 * between[1:] * np.sign(between[0])]
    )


@pytest.fixture(scope="module")
def replayed(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    folder = tmp_path_factory.mktemp("full_pose")
    rows = ["t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz"]
    for t_s in np.linspace(0.0, PERIOD_S, 201):
        rows.append(",".join(f"{value:.9f}" for value in (t_s, *position_mm(t_s), *attitude(t_s))))
    (folder / "motion.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    motion = ("--trajectory", str(folder / "motion.csv"), "--leds", "3", "--frames", str(PICTURES))
    subprocess.run([renderer(), *motion, "--out", str(folder / "recording")], check=True, timeout=120.0)
    known = ("--calibration", str(CONFIG.parent / "calibration.toml"), "--target", str(CONFIG.parent / "target.toml"))
    replay = finished("replay", str(folder / "recording"), *known, "--config", str(CONFIG), limit_s=60.0)
    assert replay.returncode == 0, replay.stderr
    return [json.loads(line) for line in replay.stdout.splitlines()]


def test_nearly_every_verdict_is_a_full_pose_of_three_points(replayed: list[dict[str, Any]]) -> None:
    assert len(replayed) >= 0.9 * PICTURES
    full = [verdict for verdict in replayed if verdict["orientation_valid"]]
    assert len(full) >= 0.9 * len(replayed)
    for verdict in full:
        assert [point["id"] for point in verdict["points"]] == [1, 2, 3]
        assert verdict["faults"] == []


def squares(
    errors: list[Floats], replayed: list[dict[str, Any]], spread_of: Callable[[dict[str, Any]], Floats]
) -> Floats:
    """Chi-square of each error, six degrees of freedom."""
    spreads = [spread_of(verdict) for verdict in replayed if verdict["valid"]]
    return np.array([error @ np.linalg.solve(spread, error) for error, spread in zip(errors, spreads, strict=True)])


def test_position_and_orientation_agree_with_the_truth_as_well_as_stated(replayed: list[dict[str, Any]]) -> None:
    errors = [error_of(verdict) for verdict in replayed if verdict["valid"]]
    chi2 = squares(errors, replayed, lambda verdict: np.array(verdict["covariance"]))
    noise_chi2 = squares(errors, replayed, lambda v: np.array(v["covariance"]) - np.array(v["covariance_shared"]))
    assert np.mean(chi2 < CHI2_6_AT_999) >= 0.98
    assert np.mean(noise_chi2 < CHI2_6_AT_999) >= 0.95  # this calibration is exact: noise alone explains the errors
    worst_mm = max(float(np.linalg.norm(error[:3])) for error in errors)
    worst_deg = max(float(np.degrees(np.linalg.norm(error[3:]))) for error in errors)
    print(
        f"chi2 mean {chi2.mean():.2f} of 6, largest {chi2.max():.1f}; worst {worst_mm:.2f} mm, {worst_deg:.2f} degrees"
    )
    assert worst_mm < 1.0
    assert worst_deg < 1.0
