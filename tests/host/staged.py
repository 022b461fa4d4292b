"""A unit and a clock that follow a script: no network and no waiting."""

from collections.abc import Iterable
from dataclasses import replace

from host_tool.contract.blocks import Answer, Camera, Health, Pose, State, Timing
from host_tool.contract.conditions import Status

POSE = Pose(
    sequence=1,
    status=int(Status.POSITION_VALID | Status.SIMULATED),
    faults=0,
    warnings=0,
    exposed_utc_ns=1_795_000_000_000_000_000,
    age_ms=20.0,
    position_mm=(0.0, 0.0, 400.0),
    angles_deg=None,
    quaternion_wxyz=None,
    uncertainty_mm=(0.1, 0.1, 0.3),
    uncertainty_deg=None,
    residual_px=0.05,
    points_used=1,
    setup=1,
)
STATE = State(heartbeat=1, status=POSE.status, faults=0, warnings=0, state="measuring", clients=1, uptime_s=1)

CAMERA = Camera("delivering", 30.0, 2000.0, None, None, 0, 1, 98.0, 20.0, None, 0, 2.1, 11.8)
HEALTH = Health(CAMERA, CAMERA, Timing(None, None, None, None, None, None, None, None, None, None))


def answer(pose: Pose = POSE) -> Answer:
    return Answer(replace(STATE, status=pose.status, faults=pose.faults, warnings=pose.warnings), pose)


class StagedClock:
    """Time passes only by sleeping."""

    def __init__(self) -> None:
        self.time_s = 100.0

    def now_s(self) -> float:
        return self.time_s

    def sleep(self, seconds: float) -> None:
        self.time_s += seconds


class StagedUnit:
    """Gives its answers one after the other, then the last one for ever."""

    def __init__(self, poses: Iterable[Pose]) -> None:
        self._answers = [answer(pose) for pose in poses]

    def read_pose(self) -> Answer:
        return self._answers.pop(0) if len(self._answers) > 1 else self._answers[0]

    def read_health(self) -> Health:
        return HEALTH


def poses_numbered(*sequences: int) -> list[Pose]:
    return [replace(POSE, sequence=sequence) for sequence in sequences]
