"""A PLC that runs the blocks of deploy/plc, one cycle at a time, its Modbus client as simple as one can be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Protocol

from host_tool.errors import DeviceError
from structured_text.execution import Runtime
from structured_text.program import Program, program_from
from structured_text.values import Array, Structure, Value

BLOCKS = sorted((Path(__file__).parents[2] / "deploy/plc").glob("*.st"))
BUFFER = 116


@cache
def shipped_program() -> Program:
    """The blocks of deploy/plc; reading them takes seconds."""
    return program_from(BLOCKS)


class Wire(Protocol):
    """Carries one request; raises DeviceError when it fails."""

    def read(self, address: int, quantity: int) -> Sequence[int]:
        """FC 3."""
        ...

    def write(self, address: int, value: int) -> None:
        """FC 6."""
        ...


@dataclass(slots=True)
class Plc:
    """One TripointUnit with its client. `cycle` is one pass of the PLC's task; an answer takes a cycle."""

    program: Program
    wire: Wire
    limits: dict[str, Any]
    runtime: Runtime = field(init=False)
    unit: Structure = field(init=False)
    words: list[int] = field(default_factory=lambda: [0] * BUFFER)
    asked: list[tuple[int, int]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.runtime = Runtime(self.program)
        self.unit = self.runtime.instance("TripointUnit")

    def cycle(self, now_ms: int, latch: bool = False) -> None:
        """The client first, then the block, as the guide says."""
        self.runtime.clock.now_ms = now_ms
        done, error = self._client()
        self.runtime.call(self.unit, self._inputs(done, error, latch))

    def said(self, path: str) -> Any:
        """An output, as said("live.pose.x_mm")."""
        place: Any = self.unit
        for name in path.split("."):
            place = place.members[name]
        return place.data

    def _client(self) -> tuple[bool, bool]:
        if not self.said("start"):
            return False, False
        address, quantity = self.said("address"), self.said("quantity")
        self.asked.append((address, quantity))
        try:
            if self.said("writing"):
                self.wire.write(address, self.said("value"))
            else:
                self.words[:quantity] = self.wire.read(address, quantity)
        except DeviceError:
            return False, True
        return True, False

    def _inputs(self, done: bool, error: bool, latch: bool) -> dict[str, Any]:
        limits = self.runtime.instance("TripointLimits")
        for name, data in self.limits.items():
            limits.members[name] = Value(limits.members[name].type, data)
        return {
            "words": Array("WORD", 0, [Value("WORD", word) for word in self.words]),
            "done": Value("BOOL", done),
            "error": Value("BOOL", error),
            "limits": limits,
            "latch": Value("BOOL", latch),
        }
