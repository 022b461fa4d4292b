"""A PLC before a unit that misbehaves as told: for the tests of the blocks in deploy/plc."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from host.register_image import Image
from structured_text.fake_wire import SETUP, UNKNOWN_32, UNKNOWN_U32, FakeWire
from structured_text.plc import Plc, shipped_program

CYCLE_MS = 10
LIMITS: dict[str, Any] = {
    "setup": SETUP,
    "age_ms": 200,
    "latched_age_ms": 5000,
    "uncertainty_mm": 0.5,
    "uncertainty_deg": 0.1,
    "orientation": True,
    "verified": True,
}
NO_POSE_MM = -2147483.648
Spoil = Callable[[Image], None]


def staged_plc(**limits: Any) -> Plc:
    """The shipped blocks before a unit without a network; `limits` beside the usual ones."""
    return Plc(shipped_program(), FakeWire(), LIMITS | limits)


def wire_of(plc: Plc) -> FakeWire:
    assert isinstance(plc.wire, FakeWire)
    return plc.wire


def cycles(plc: Plc, count: int, latch: bool = False, cycle_ms: int = CYCLE_MS) -> Iterator[int]:
    """Runs; hands the time after each cycle."""
    for _ in range(count):
        now_ms = plc.runtime.clock.now_ms + cycle_ms
        plc.cycle(now_ms, latch)
        yield now_ms


def run(plc: Plc, count: int, latch: bool = False) -> None:
    for _ in cycles(plc, count, latch):
        pass


def put(address: int, kind: str, *values: float) -> Spoil:
    return lambda image: image.put(address, kind, *values)


def clear(bit: int) -> Spoil:
    return lambda image: image.put(101, "H", image.words[101] & ~(1 << bit))


def raise_bit(bit: int) -> Spoil:
    return lambda image: image.put(101, "H", image.words[101] | 1 << bit)


REFUSALS: list[tuple[str, Spoil, int]] = [
    ("torn", put(147, "H", 1), 3),
    ("another setup", put(146, "H", 0xABCE), 4),
    ("simulated", raise_bit(9), 5),
    ("position not valid", clear(2), 6),
    ("orientation not valid", clear(3), 6),
    ("stale", raise_bit(4), 6),
    ("x unknown", put(110, "I", UNKNOWN_32), 6),
    ("z unknown", put(114, "I", UNKNOWN_32), 6),
    ("B unknown", put(118, "I", UNKNOWN_32), 6),
    ("quaternion unknown", put(122, "I", UNKNOWN_32), 6),
    ("not verified", clear(13), 7),
    ("mount not watched", clear(14), 7),
    ("too old", put(108, "I", 195_000), 8),
    ("age unknown", put(108, "I", UNKNOWN_U32), 8),
    ("a warning", put(103, "H", 1 << 2), 9),
    ("x uncertain", put(130, "I", 500_001), 10),
    ("z uncertainty unknown", put(134, "I", UNKNOWN_U32), 10),
    ("gimbal lock: A uncertainty unknown", put(136, "I", UNKNOWN_U32), 10),
    ("C uncertain", put(140, "I", 100_001), 10),
]
