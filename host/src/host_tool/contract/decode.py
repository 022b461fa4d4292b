"""From raw register words to values; the places, types, scales and unknowns come from the register map."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from host_tool.contract.blocks import (
    Camera,
    Health,
    Identity,
    Point,
    Pose,
    Quadruple,
    State,
    Timing,
    Triple,
)
from host_tool.contract.register_map import Block, register_map
from host_tool.contract.words import WordOrder, float32, signed, unsigned
from host_tool.errors import DeviceError

MAGIC = 0x5450
MAX_POINTS = 12
DIGITS = 12  # no scale of the map is finer; takes away the noise of binary fractions


@dataclass(frozen=True, slots=True)
class BlockWords:
    """The words of one block as they came from the wire, with the order they came in."""

    block: Block
    words: Sequence[int]
    order: WordOrder = WordOrder.ABCD

    def raw(self, name: str) -> int | float:
        """The number as transmitted, before scale and unknown."""
        register = self.block.registers[name]
        start = register.address - self.block.first
        words = self.words[start : start + register.count]
        if register.type == "f32":
            return float32(words, self.order)
        return signed(words, self.order) if register.type.startswith("i") else unsigned(words, self.order)

    def number(self, name: str) -> float | None:
        """The value in its unit; None when it reads as unknown."""
        register, raw = self.block.registers[name], self.raw(name)
        if isinstance(raw, float):
            return raw if math.isfinite(raw) else None
        if register.unknown is not None and raw % (1 << 16 * register.count) == register.unknown:
            return None
        return round(raw * register.scale, DIGITS)

    def integer(self, name: str) -> int:
        """A counter, an id or bits: always known, never scaled."""
        return int(self.raw(name))

    def triple(self, *names: str) -> Triple | None:
        """Three values, or None when any of them is unknown: half a position is none."""
        x, y, z = (self.number(name) for name in names)
        return None if x is None or y is None or z is None else (x, y, z)


def words_of(name: str, words: Sequence[int], order: WordOrder = WordOrder.ABCD) -> BlockWords:
    """Names the words of a block of the map."""
    return BlockWords(register_map().blocks[name], words, order)


def identity_of(words: BlockWords) -> Identity:
    """Raises DeviceError E-DEV-01 when it is no Tripoint, E-DEV-02 when its map is of another major version."""
    if words.integer("magic") != MAGIC:
        raise DeviceError("E-DEV-01", "a Modbus server answers, but it is no Tripoint", "check --device")
    if words.integer("map_major") != register_map().major:
        raise DeviceError(
            "E-DEV-02",
            f"the unit has register map {words.integer('map_major')}, this host-tool knows {register_map().major}",
            "install the host-tool that belongs to the unit's firmware",
        )
    firmware = (words.integer(f"firmware_{part}") for part in ("major", "minor", "patch"))
    choice = register_map().choice
    return Identity(
        map_major=words.integer("map_major"),
        map_minor=words.integer("map_minor"),
        serial_number=words.integer("serial_number"),
        firmware=".".join(str(part) for part in firmware),
        mode=choice("mode", words.integer("mode")),
        calibration_id=words.integer("calibration_id"),
        configuration_id=words.integer("configuration_id"),
        output_frame=choice("output_frame", words.integer("output_frame")),
    )


def state_of(words: BlockWords) -> State:
    """What the unit is doing."""
    return State(
        heartbeat=words.integer("heartbeat"),
        status=words.integer("status"),
        faults=words.integer("faults"),
        warnings=words.integer("warnings"),
        state=register_map().choice("state", words.integer("state")),
        clients=words.integer("clients"),
        uptime_s=words.integer("uptime"),
    )


def pose_of(words: BlockWords) -> Pose:
    """Any of the four pose blocks; raises DeviceError E-DEV-03 when its two sequence numbers differ."""
    check_whole(words)
    points = words.integer("points_used") if "points_used" in words.block.registers else None
    age = "extrapolated" if "extrapolated" in words.block.registers else "age"
    return Pose(
        sequence=words.integer("sequence_long"),
        status=words.integer("status"),
        faults=words.integer("faults"),
        warnings=words.integer("warnings"),
        exposed_utc_ns=words.integer("time"),
        age_ms=words.number(age),
        position_mm=words.triple("x", "y", "z"),
        angles_deg=words.triple("a", "b", "c"),
        quaternion_wxyz=_quaternion(words),
        uncertainty_mm=words.triple("uncertainty_x", "uncertainty_y", "uncertainty_z"),
        uncertainty_deg=words.triple("uncertainty_a", "uncertainty_b", "uncertainty_c"),
        residual_px=words.number("residual"),
        points_used=points,
        setup=words.integer("setup"),
    )


def points_of(words: BlockWords) -> tuple[Point, ...]:
    """The points that were measured; raises DeviceError E-DEV-03 when torn."""
    check_whole(words)
    count = min(words.integer("count"), MAX_POINTS)
    points = (_point(words, place) for place in range(1, count + 1))
    return tuple(point for point in points if point is not None)


def health_of(left: BlockWords, right: BlockWords, timing: BlockWords) -> Health:
    """Cameras and timing."""
    return Health(_camera(left), _camera(right), _timing(timing))


def check_whole(words: BlockWords) -> None:
    """A block carries its sequence first and last: raises DeviceError E-DEV-03 when they differ."""
    first, last = words.integer("sequence"), words.integer("sequence_end")
    if first != last:
        raise DeviceError(
            "E-DEV-03",
            f"the {words.block.name} block is torn: sequence {first} first, {last} last",
            "a unit never sends this in one answer: look for a gateway between, and read the block in one request",
        )


def _quaternion(words: BlockWords) -> Quadruple | None:
    w, x, y, z = (words.number(name) for name in ("qw", "qx", "qy", "qz"))
    return None if w is None or x is None or y is None or z is None else (w, x, y, z)


def _point(words: BlockWords, place: int) -> Point | None:
    position_mm = words.triple(f"x_{place}", f"y_{place}", f"z_{place}")
    if position_mm is None:
        return None
    flags = words.integer(f"flags_{place}")
    return Point(
        identity=words.integer(f"id_{place}"),
        position_mm=position_mm,
        uncertainty_mm=words.number(f"uncertainty_{place}"),
        residual_px=words.number(f"residual_{place}"),
        saturated=bool(flags & 1),
        weak=bool(flags & 2),
    )


def _camera(words: BlockWords) -> Camera:
    return Camera(
        state=register_map().choice("camera_state", words.integer("state")),
        rate_hz=words.number("frames_per_second"),
        exposure_us=words.number("exposure"),
        gain=words.number("gain"),
        temperature_c=words.number("temperature"),
        dropped_frames=words.integer("dropped"),
        spots=words.integer("spots"),
        spot_peak=words.number("spot_peak"),
        image_mean=words.number("image_mean"),
        focus_per_px=words.number("focus"),
        resets=words.integer("resets"),
        above_dim=words.number("above_dim") or None,  # 0: a unit with map 1.0, which does not tell
        below_clipping=words.number("below_clipping") or None,
    )


def _timing(words: BlockWords) -> Timing:
    return Timing(
        skew_us=words.number("skew"),
        skew_uncertainty_us=words.number("skew_uncertainty"),
        skew_cost_mm=words.number("skew_cost"),
        latency_p50_us=words.number("latency_p50"),
        latency_p99_us=words.number("latency_p99"),
        epipolar_rms_px=words.number("epipolar_rms"),
        side_length_error_mm=words.number("side_length_error"),
        decalibration_mm=words.number("decalibration"),
        cpu_temperature_c=words.number("cpu_temperature"),
        load_percent=words.number("load"),
    )
