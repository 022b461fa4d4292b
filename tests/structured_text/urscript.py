"""Runs the URScript of deploy/plc: what it uses of the language differs from Python by `end` and `local` alone."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

SCRIPT = Path(__file__).parents[2] / "deploy/plc/tripoint_ur.script"
OPENS = re.compile(r"^(def|if|while)\b.*:$")
REGISTER_INPUT, REGISTER_OUTPUT = 2, 3


def python_from(text: str) -> str:
    """The same program for Python; ValueError where a block's `end` does not stand under its beginning."""
    lines: list[str] = []
    open_at: list[int] = []
    for number, line in enumerate(text.splitlines(), 1):
        code = line.split("#")[0].rstrip()
        indent = len(code) - len(code.lstrip())
        if code.strip() == "end":
            if not open_at or open_at.pop() != indent:
                raise ValueError(f"line {number}: this end closes no block")
            continue
        if code and indent != 2 * len(open_at):
            raise ValueError(f"line {number}: indented by {indent}, not {2 * len(open_at)}")
        if OPENS.match(code.strip()):
            open_at.append(indent)
        lines.append(re.sub(r"\blocal ", "", code))
    if open_at:
        raise ValueError(f"{len(open_at)} blocks have no end")
    return "\n".join(lines)


@dataclass(slots=True)
class Robot:
    """A controller with its Modbus client: every signal is one request for one register, on demand."""

    read: Callable[[int], int]  # FC 4, or FC 3 for an output
    write: Callable[[int, int], None]
    sleep: Callable[[float], None]
    signals: dict[str, tuple[int, int]] = field(default_factory=dict)
    frequencies: dict[str, int] = field(default_factory=dict)

    def functions(self, script: Path = SCRIPT) -> dict[str, Any]:
        """The script's functions, with the robot's own beneath them."""
        names: dict[str, Any] = {
            "modbus_add_signal": self._add,
            "modbus_set_signal_update_frequency": self.frequencies.__setitem__,
            "modbus_get_signal_status": lambda name, _: self.read(self.signals[name][0]),
            "modbus_set_output_register": self._set,
            "integer_to_binary_list": lambda value: [bool(value >> bit & 1) for bit in range(32)],
            "floor": math.floor,
            "sleep": self.sleep,
        }
        exec(compile(python_from(script.read_text(encoding="utf-8")), script.name, "exec"), names)
        return names

    def _add(self, *signal: Any) -> None:
        _, unit, address, kind, name = signal
        assert unit == 255
        self.signals[name] = (address, kind)

    def _set(self, name: str, value: int, _: bool) -> None:
        address, kind = self.signals[name]
        assert kind == REGISTER_OUTPUT
        self.write(address, value)
