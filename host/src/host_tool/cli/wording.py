"""Poses and conditions as words and as JSON: the same in every command."""

from datetime import UTC, datetime
from typing import Any

from host_tool.cli.output import number
from host_tool.contract.blocks import Answer, Pose
from host_tool.contract.conditions import Condition, faults_in, status_names, warnings_in
from host_tool.watching.session import Scene

WORTH_SAYING_S = 0.1  # a verdict or two without a position have no "for"


def time_of(utc_ns: int) -> str:
    """Time of day in UTC with ms; a dash before the first verdict."""
    if utc_ns == 0:
        return "-"
    return datetime.fromtimestamp(utc_ns // 1_000_000 / 1000, tz=UTC).strftime("%H:%M:%S.%f")[:-3]


def age_of(pose: Pose) -> str:
    """Age in ms when the answer was made."""
    return number(pose.age_ms, 1, "ms")


def conditions_of(answer: Answer) -> list[tuple[str, Condition]]:
    """Everything set, faults first, of this pose and of the unit now."""
    faults = answer.pose.faults | answer.state.faults
    warnings = answer.pose.warnings | answer.state.warnings
    return [("fault", fault) for fault in faults_in(faults)] + [
        ("warning", warning) for warning in warnings_in(warnings)
    ]


def position_of(pose: Pose, without_s: float | None = None) -> str:
    """x y z with expanded uncertainty, or that there is none, and for how long."""
    if not pose.position_valid or pose.position_mm is None or pose.uncertainty_mm is None:
        return "no valid position" + (f" for {without_s:.1f} s" if without_s and without_s >= WORTH_SAYING_S else "")
    axes = zip("xyz", pose.position_mm, pose.uncertainty_mm, strict=True)
    return "  ".join(f"{name} {value:9.3f} ±{spread:.3f}" for name, value, spread in axes) + " mm"


def orientation_of(pose: Pose) -> str | None:
    """A B C with expanded uncertainty; None where the pose has no valid orientation."""
    if not pose.orientation_valid or pose.angles_deg is None:
        return None
    spreads = pose.uncertainty_deg or (None, None, None)  # absent in gimbal lock
    axes = zip("ABC", pose.angles_deg, spreads, strict=True)
    return "  ".join(f"{name} {angle:8.3f} ±{number(spread, 3)}" for name, angle, spread in axes) + " deg"


def line_of(scene: Scene) -> str:
    """One verdict in one line."""
    sighting, comparison = scene.sighting, scene.comparison
    pose = sighting.answer.pose
    position = position_of(pose, scene.without_s)
    parts = [time_of(pose.exposed_utc_ns), f"#{pose.sequence}", position]
    orientation = orientation_of(pose)
    if orientation is not None:
        parts.append(orientation)
    parts.append(f"age {age_of(pose)}")
    if scene.speed_mm_per_s is not None:
        parts.append(f"speed {scene.speed_mm_per_s:.0f} mm/s")
    if comparison is not None:
        inside = "inside" if comparison.inside else "OUTSIDE"
        turned = "" if comparison.turned_deg is None else f", {comparison.turned_deg:.3f} deg"
        parts.append(f"error {comparison.error_mm:.3f} mm {inside} k=2{turned}")
    if not sighting.fresh:
        parts.append("NOTHING NEW")
    if sighting.missed:
        parts.append(f"({sighting.missed} missed)")
    parts += [condition.words for kind, condition in conditions_of(sighting.answer) if kind == "fault"]
    return "  ".join(parts)


def record_of(scene: Scene) -> dict[str, Any]:
    """One verdict for machines."""
    sighting, comparison = scene.sighting, scene.comparison
    state, pose = sighting.answer.state, sighting.answer.pose
    return {
        "sequence": pose.sequence,
        "heartbeat": state.heartbeat,
        "state": state.state,
        "fresh": sighting.fresh,
        "missed": sighting.missed,
        "exposed_utc_ns": pose.exposed_utc_ns,
        "age_ms": pose.age_ms,
        "valid": pose.position_valid,
        "orientation_valid": pose.orientation_valid,
        "without_s": scene.without_s,
        "position_mm": pose.position_mm,
        "uncertainty_mm": pose.uncertainty_mm,
        "quaternion_wxyz": pose.quaternion_wxyz,
        "angles_deg": pose.angles_deg,
        "uncertainty_deg": pose.uncertainty_deg,
        "speed_mm_per_s": scene.speed_mm_per_s,
        "residual_px": pose.residual_px,
        "setup": pose.setup,
        "status": status_names(pose.status),
        "faults": [condition.name for condition in faults_in(pose.faults)],
        "warnings": [condition.name for condition in warnings_in(pose.warnings)],
        "truth_mm": None if comparison is None else comparison.truth_mm,
        "error_mm": None if comparison is None else comparison.error_mm,
        "inside": None if comparison is None else comparison.inside,
        "turned_deg": None if comparison is None else comparison.turned_deg,
        "exposure": {
            side: {"above_dim": camera.above_dim, "below_clipping": camera.below_clipping}
            for side, camera in (("left", scene.health.left), ("right", scene.health.right))
        },
    }
