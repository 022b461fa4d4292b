"""Measured against truth: the error of one pose and whether its stated uncertainty holds the truth."""

import math
from dataclasses import dataclass

import numpy as np

from host_tool.contract.blocks import Identity, Pose, Triple
from host_tool.errors import UsageError
from host_tool.trajectories.paths import Path


@dataclass(frozen=True, slots=True)
class Comparison:
    """Measured against true pose, at its exposure time."""

    truth_mm: Triple
    error_mm: float  # length of the 3D error
    inside: bool  # within the k = 2 interval on all three axes
    turned_deg: float | None = None  # from the true attitude; None where the pose has no valid orientation


def compared(pose: Pose, truth: Path) -> Comparison | None:
    """None where the pose has no valid position."""
    if not pose.position_valid or pose.position_mm is None or pose.uncertainty_mm is None:
        return None
    true_mm = truth.position_at_utc_mm(pose.exposed_utc_ns)
    error_mm = np.array(pose.position_mm) - true_mm
    x_mm, y_mm, z_mm = true_mm.tolist()
    return Comparison(
        truth_mm=(x_mm, y_mm, z_mm),
        error_mm=float(np.linalg.norm(error_mm)),
        inside=bool(np.all(np.abs(error_mm) <= np.array(pose.uncertainty_mm))),
        turned_deg=_turned_deg(pose, truth),
    )


def _turned_deg(pose: Pose, truth: Path) -> float | None:
    if not pose.orientation_valid or pose.quaternion_wxyz is None:
        return None
    a, b = np.array(pose.quaternion_wxyz), truth.attitude_at_utc_wxyz(pose.exposed_utc_ns)
    sine = np.linalg.norm(a[0] * b[1:] - b[0] * a[1:] - np.cross(a[1:], b[1:]))  # of half the turn between them
    return math.degrees(2.0 * math.atan2(float(sine), abs(float(a @ b))))


def check_scenario_on(simulated: bool) -> None:
    """A scenario says where a simulated target is; what real cameras see follows none (UsageError E-USE-07)."""
    if not simulated:
        raise UsageError(
            "E-USE-07",
            "this unit measures real cameras: a scenario does not say where its target is",
            "give --truth a CSV of where the target truly is, or leave --truth away",
        )


def check_comparable(identity: Identity) -> None:
    """Truth is given in the reference frame: poses in another cannot be compared (UsageError E-USE-02)."""
    if identity.output_frame != "reference":
        raise UsageError(
            "E-USE-02",
            f"the unit's output frame is {identity.output_frame}, truth is in reference",
            "set the output frame of the unit to reference, or leave --truth away",
        )
