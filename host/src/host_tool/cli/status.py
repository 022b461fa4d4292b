"""host-tool status: what the unit is, how it is set up, and how it is."""

from typing import Any

import click

from host_tool.appliance.unit import open_unit
from host_tool.cli.exposure import margin_of
from host_tool.cli.options import Common, common_options
from host_tool.cli.output import identification, number, print_json
from host_tool.cli.plight import doing
from host_tool.cli.wording import age_of, conditions_of, position_of, time_of
from host_tool.contract.blocks import Answer, Camera, Health, Identity, Timing
from host_tool.contract.conditions import Status, status_names


@click.command(epilog="Example: host-tool status --device 192.168.1.20:502")
@common_options
def status(common: Common) -> None:
    """Say what the unit is and how it is.

    Identity, setup, what it is doing and what it lacks, faults and warnings with a remedy each, cameras and timing.
    """
    with open_unit(common.address, common.timeout_s) as unit:
        identity, answer, health = unit.identity, unit.read_pose(), unit.read_health()
    if common.as_json:
        print_json(_record(identity, answer, health))
        return
    rows = _identity_rows(identity, answer) + _state_rows(answer, health) + _health_rows(health, answer.state.status)
    for name, text in rows:
        click.echo(f"{name:<13}{text}")


def _record(identity: Identity, answer: Answer, health: Health) -> dict[str, Any]:
    conditions = conditions_of(answer)
    return {
        "identity": identity,
        "state": answer.state,
        "status": status_names(answer.state.status),
        "pose": answer.pose,
        "faults": [condition for kind, condition in conditions if kind == "fault"],
        "warnings": [condition for kind, condition in conditions if kind == "warning"],
        "cameras": {"left": health.left, "right": health.right},
        "timing": health.timing,
    }


def _identity_rows(identity: Identity, answer: Answer) -> list[tuple[str, str]]:
    simulated = ", SIMULATED" if answer.state.status & Status.SIMULATED else ""
    calibration = identification(identity.calibration_id, 8) if identity.calibration_id else "none"
    return [
        ("unit", f"serial {identity.serial_number}, firmware {identity.firmware}"),
        ("map", f"{identity.map_major}.{identity.map_minor}"),
        ("mode", f"{_words(identity.mode)}{simulated}"),
        ("frame", _words(identity.output_frame)),
        ("calibration", calibration),
        ("config", identification(identity.configuration_id, 8)),
        ("setup", f"{identification(answer.pose.setup, 4)}, register 146: what a PLC compares"),
    ]


def _state_rows(answer: Answer, health: Health) -> list[tuple[str, str]]:
    state, pose = answer.state, answer.pose
    return [
        ("state", doing(answer, health)),
        ("running", f"for {state.uptime_s} s, Modbus clients {state.clients}"),
        ("status", ", ".join(_words(name) for name in status_names(state.status)) or "-"),
        ("position", position_of(pose)),
        ("exposed", f"{time_of(pose.exposed_utc_ns)} UTC, age {age_of(pose)}"),
        *((kind, f"{condition.words}: {condition.remedy}") for kind, condition in conditions_of(answer)),
    ]


def _health_rows(health: Health, status: int) -> list[tuple[str, str]]:
    return [
        ("left", _camera(health.left)),
        ("", margin_of(health.left)),
        ("right", _camera(health.right)),
        ("", margin_of(health.right)),
        *_timing_rows(health.timing, status),
    ]


def _camera(camera: Camera) -> str:
    return (
        f"{camera.state}, {number(camera.rate_hz, 2, 'fps')}, exposure {number(camera.exposure_us, 0, 'us')}, "
        f"{camera.dropped_frames} dropped, resets {camera.resets}, spots {camera.spots}, "
        f"peak {number(camera.spot_peak, 0)}, mean {number(camera.image_mean, 0)}"
    )


def _timing_rows(timing: Timing, status: int) -> list[tuple[str, str]]:
    skew, spread = number(timing.skew_us, 0, "us"), number(timing.skew_uncertainty_us, 0, "us")
    p50, p99 = number(timing.latency_p50_us, 0, "us"), number(timing.latency_p99_us, 0, "us")
    return [
        (
            "skew",
            f"right minus left {skew}, ± {spread}, uncorrected it would cost {number(timing.skew_cost_mm, 3, 'mm')}",
        ),
        ("latency", f"p50 {p50}, p99 {p99} from the later frame to the registers"),
        ("epipolar", f"{number(timing.epipolar_rms_px, 3, 'px')} RMS"),
        (
            "mount",
            f"sides of the target off by {number(timing.side_length_error_mm, 3, 'mm')}, "
            f"moved cameras misplace it by {number(timing.decalibration_mm, 3, 'mm')}, {_watched(status)}",
        ),
        ("board", f"{number(timing.cpu_temperature_c, 1, 'degC')}, load {number(timing.load_percent, 0, '%')}"),
    ]


def _watched(status: int) -> str:
    return f"{'a' if status & Status.MOUNT_WATCHED else 'no'} datum is seen where it belongs"


def _words(name: str) -> str:
    return name.replace("_", " ")
