"""The status bits by name, and for each fault and warning what to do about it."""

from dataclasses import dataclass
from enum import IntFlag

from host_tool.contract.register_map import register_map


class Status(IntFlag):
    """Register 33, and 101 for one pose; a test holds it equal to registers.toml."""

    READY = 1 << 0
    TRACKING = 1 << 1
    POSITION_VALID = 1 << 2
    ORIENTATION_VALID = 1 << 3
    STALE = 1 << 4
    DEGRADED = 1 << 5
    CALIBRATED = 1 << 6
    REGISTERED = 1 << 7
    CLOCK_SYNCHRONISED = 1 << 8
    SIMULATED = 1 << 9
    SETTLED = 1 << 10
    GIMBAL_LOCK = 1 << 11
    LATCHED = 1 << 12
    VERIFIED = 1 << 13
    MOUNT_WATCHED = 1 << 14


@dataclass(frozen=True, slots=True)
class Condition:
    """One fault or warning: `name` is the machine's word, `words` and `remedy` are for people."""

    name: str
    words: str
    remedy: str


REMEDIES: dict[str, str] = {
    "no_calibration": "calibrate, or set calibration.file in the configuration",
    "left_camera_lost": "check cable, power and [cameras.left]; measuring resumes by itself",
    "right_camera_lost": "check cable, power and [cameras.right]; measuring resumes by itself",
    "not_seen_left": "check line of sight, LED supply and exposure",
    "not_seen_right": "check line of sight, LED supply and exposure",
    "ambiguous": "cover other red lights and mirrors in view",
    "epipolar_gate": "look for reflections, then verify the calibration",
    "geometry_gate": "check target.file against the tool",
    "outside_volume": "move the target in, or check [volume]",
    "timing_bound": "move slower, or check the cameras' rates",
    "decalibration": "check mount and target for what was moved: put it back and show the whole target, or recalibrate",
    "calibration_does_not_fit": "connect the calibrated cameras, or recalibrate",
    "internal": "save the unit's log and report it",
    "saturated_spot": "shorten the exposure or dim the LED",
    "weak_spot": "lengthen the exposure, brighten or clean the LED",
    "high_residual": "verify the calibration by a length",
    "calibration_old": "recalibrate",
    "temperature": "cool the unit",
    "frames_dropped": "check USB bandwidth and load",
    "disk_nearly_full": "delete recordings",
    "no_unique_serial": "never swap the cables of the two cameras",
    "warm_up": "wait until it is warm before measuring to the limit",
    "refused_clients": "check the limits and the allow-list in [modbus]",
    "resource_missing": "read the unit's log for disk, line or permission",
    "light_unproved": "keep other red lights out of view, let the LEDs blink, or use three",
}


def faults_in(bits: int) -> tuple[Condition, ...]:
    """Why there is no valid pose."""
    return _conditions("fault", bits)


def warnings_in(bits: int) -> tuple[Condition, ...]:
    """What to look at although the pose stands."""
    return _conditions("warning", bits)


def status_names(bits: int) -> tuple[str, ...]:
    """The set status bits by name, lowest first."""
    return tuple(meaning.name for meaning in register_map().bits_set("status", bits))


def _conditions(group: str, bits: int) -> tuple[Condition, ...]:
    return tuple(
        Condition(meaning.name, meaning.meaning, REMEDIES.get(meaning.name, "update host-tool"))
        for meaning in register_map().bits_set(group, bits)
    )
