"""The blocks of the register map as values: units in the names, None for what the unit calls not valid."""

from dataclasses import dataclass

from host_tool.contract.conditions import Status

Triple = tuple[float, float, float]
Quadruple = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Identity:
    """Registers 0 to 18; `mode` and `output_frame` are names of the choices of the map."""

    map_major: int
    map_minor: int
    serial_number: int
    firmware: str
    mode: str
    calibration_id: int
    configuration_id: int
    output_frame: str


@dataclass(frozen=True, slots=True)
class State:
    """Registers 32 to 39; `state` is a name of the choices "state" of the map."""

    heartbeat: int
    status: int
    faults: int
    warnings: int
    state: str
    clients: int
    uptime_s: int


@dataclass(frozen=True, slots=True)
class Pose:
    """One verdict, from the integer block (100 to 147) or a float block (200 to 247, 250 to 297).

    Uncertainties are expanded (k = 2). `age_ms` is None before the first verdict since start. In the
    predicted block `age_ms` is how far the pose was extrapolated.
    """

    sequence: int
    status: int
    faults: int
    warnings: int
    exposed_utc_ns: int
    age_ms: float | None
    position_mm: Triple | None
    angles_deg: Triple | None  # A, B, C with R = Rz(A) Ry(B) Rx(C)
    quaternion_wxyz: Quadruple | None
    uncertainty_mm: Triple | None
    uncertainty_deg: Triple | None
    residual_px: float | None
    points_used: int | None  # only the integer block tells
    setup: int

    @property
    def position_valid(self) -> bool:
        """Whether x, y, z may be used: the rule of map 1 for a client that wants the position alone."""
        wanted = Status.POSITION_VALID
        return self.status & (Status.POSITION_VALID | Status.STALE) == wanted and self.position_mm is not None

    @property
    def orientation_valid(self) -> bool:
        """Whether angles, quaternion and rotation vector may be used, by the same rule."""
        wanted = Status.ORIENTATION_VALID
        return self.status & (Status.ORIENTATION_VALID | Status.STALE) == wanted and self.quaternion_wxyz is not None


@dataclass(frozen=True, slots=True)
class Answer:
    """State and pose from one request (32 to 147), so that they belong together."""

    state: State
    pose: Pose


@dataclass(frozen=True, slots=True)
class Point:
    """One of registers 502 to 621: a point of the target in the output frame."""

    identity: int  # 0: a spot without one
    position_mm: Triple
    uncertainty_mm: float | None  # None: 65.535 mm or more
    residual_px: float | None
    saturated: bool
    weak: bool


@dataclass(frozen=True, slots=True)
class Camera:
    """Registers 700 to 715 (left) or 716 to 731 (right); `state` is a name of the choices "camera_state"."""

    state: str
    rate_hz: float | None
    exposure_us: float | None
    gain: float | None
    temperature_c: float | None
    dropped_frames: int
    spots: int
    spot_peak: float | None
    image_mean: float | None
    focus_per_px: float | None
    resets: int
    above_dim: float | None  # factors of light, 1 = at the limit; None without a spot, or from a unit with map 1.0
    below_clipping: float | None


@dataclass(frozen=True, slots=True)
class Timing:
    """Registers 732 to 746."""

    skew_us: float | None  # right minus left
    skew_uncertainty_us: float | None
    skew_cost_mm: float | None
    latency_p50_us: float | None
    latency_p99_us: float | None
    epipolar_rms_px: float | None
    side_length_error_mm: float | None
    decalibration_mm: float | None
    cpu_temperature_c: float | None
    load_percent: float | None


@dataclass(frozen=True, slots=True)
class Health:
    """Registers 700 to 746."""

    left: Camera
    right: Camera
    timing: Timing
