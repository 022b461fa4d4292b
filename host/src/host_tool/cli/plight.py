"""What the unit is doing, as a person would tell it: which camera, what is missing, since when."""

from host_tool.contract.blocks import Answer, Camera, Health
from host_tool.contract.conditions import Status, faults_in

NOT_SEEN = {"not_seen_left": "left", "not_seen_right": "right"}


def doing(answer: Answer, health: Health) -> str:
    """One sentence for the state of the unit."""
    state = answer.state.state
    if state == "searching":
        return f"searching: {_missing(answer)}; {_since(answer)}"
    if state in ("starting", "camera_fault"):
        return f"{state.replace('_', ' ')}: {_silent(answer, health) or 'both cameras deliver, no verdict yet'}"
    if state == "no_calibration":
        return "no calibration: the cameras run, nothing is measured"
    return state.replace("_", " ")


def _missing(answer: Answer) -> str:
    """The cause of the newest verdict: no target in one camera or both, else whatever stopped the measurement."""
    faults = faults_in(answer.pose.faults)
    blind = [NOT_SEEN[fault.name] for fault in faults if fault.name in NOT_SEEN]
    if len(blind) == 2:
        return "neither camera sees the target"
    if blind:
        other = "right" if blind == ["left"] else "left"
        return f"the {blind[0]} camera does not see the target, the {other} one does"
    return ", ".join(fault.words for fault in faults) or "no position yet"


def _since(answer: Answer) -> str:
    """The registers tell whether there was ever a position, not when the last one was."""
    if answer.pose.age_ms is None:
        return f"no position since the unit started {_span(answer.state.uptime_s)} ago"
    return (
        f"it had a position before (up {_span(answer.state.uptime_s)}); host-tool watch shows for how long it is gone"
    )


def _silent(answer: Answer, health: Health) -> str:
    cameras = {"left": health.left, "right": health.right}
    lacks = {side: _never_found(camera, side, answer) or _lack(camera) for side, camera in cameras.items()}
    return ", ".join(f"the {side} camera {lack}" for side, lack in lacks.items() if lack)


def _never_found(camera: Camera, side: str, answer: Answer) -> str:
    """A real camera whose exposure is unknown has never been opened; of a recording's it is never known."""
    real = not answer.state.status & Status.SIMULATED
    if not (real and camera.state == "missing" and camera.exposure_us is None):
        return ""
    return (
        f"has not been opened since the unit started (compare [cameras.{side}] with what `tripointd cameras` lists "
        "there; the log names the cause)"
    )


def _lack(camera: Camera) -> str:
    """Empty for a camera that delivers."""
    return {
        "delivering": "",
        "starting": "has not delivered a picture yet",
        "missing": "is not there",
    }.get(camera.state, camera.state)


def _span(seconds: int) -> str:
    minutes, hours = seconds // 60, seconds // 3600
    if hours:
        return f"{hours} h {minutes % 60} min"
    return f"{minutes} min {seconds % 60} s" if minutes else f"{seconds} s"
