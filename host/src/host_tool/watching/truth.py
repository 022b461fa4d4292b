"""Measured against truth: the error of one pose and whether its stated uncertainty holds the truth."""

from dataclasses import dataclass

import numpy as np

from host_tool.contract.blocks import Identity, Pose, Triple
from host_tool.errors import UsageError
from host_tool.trajectories.paths import Path


@dataclass(frozen=True, slots=True)
class Comparison:
    """Measured minus true position, at the exposure time of the pose."""

    truth_mm: Triple
    error_mm: float  # length of the 3D error
    inside: bool  # within the k = 2 interval on all three axes


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
    )


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
