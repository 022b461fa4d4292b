"""The register map as constants of the Structured Text in deploy/plc, which stand in a section of each file."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from register_map.model import Block, MapError, Register, RegisterMap

HEAD = "VAR CONSTANT (* made from firmware/contract/registers.toml by `make docs`: do not change by hand *)\n"
SECTION = re.compile(re.escape(HEAD) + r".*?END_VAR\n", re.DOTALL)
SIGNED_BITS = {"i16": 16, "i32": 32}


@dataclass(frozen=True, slots=True)
class Constant:
    """One line of a section."""

    name: str
    type: str
    value: str
    comment: str = ""

    def __str__(self) -> str:
        return f"    {self.name} : {self.type} := {self.value};" + (f"  (* {self.comment} *)" if self.comment else "")


def with_constants(file: str, text: str, register_map: RegisterMap) -> str:
    """The text of `file` with its section made anew; MapError when it has none, or is not one we know."""
    if file not in SECTIONS:
        return text
    lines = "".join(f"{constant}\n" for constant in SECTIONS[file](register_map))
    made, found = SECTION.subn(lambda _: f"{HEAD}{lines}END_VAR\n", text)
    if found != 1:
        raise MapError(f"{file} has {found} sections that begin with: {HEAD.strip()}")
    return made


def outdated(folder: Path, register_map: RegisterMap) -> list[Path]:
    """The files of deploy/plc whose constants are not those of the map; MapError when one has no section."""
    found = []
    for name in SECTIONS:
        text = (folder / name).read_text(encoding="utf-8")
        if with_constants(name, text, register_map) != text:
            found.append(folder / name)
    return found


def _identified(register_map: RegisterMap) -> list[Constant]:
    block = register_map.block("identity")
    found = [_index(block, name) for name in ("magic", "map_major", "image_length")]
    found += [_index(block, name) for name in ("word_order_integer", "word_order_float")]
    for name in ("magic", "map_major", "image_length"):
        found.append(Constant(f"{name.upper()}_WORD", "WORD", _word(_constant(block, name))))
    for name in ("word_order_integer", "word_order_float"):
        high, low = divmod(_constant(block, name), 1 << 16)
        found.append(Constant(f"{name.upper()}_HIGH", "WORD", _word(high)))
        found.append(Constant(f"{name.upper()}_LOW", "WORD", _word(low)))
    return found


def _block(register_map: RegisterMap) -> list[Constant]:
    block = register_map.block("measured")
    found = [_index(block, "sequence", "SEQUENCE_FIRST"), _index(block, "sequence_end", "SEQUENCE_LAST")]
    found += [_index(block, name, f"{name.upper()}_WORD") for name in ("status", "faults", "warnings", "setup")]
    found += [_index(block, name) for name in ("age", "x", "y", "z", "a", "b", "c", "qw", "qx", "qy", "qz")]
    found += [_index(block, f"uncertainty_{axis}", f"U{axis.upper()}") for axis in "xyzabc"]
    for bit in ("position_valid", "orientation_valid", "stale", "simulated", "verified", "mount_watched"):
        found.append(_mask(register_map, bit))
    age = _register(block, "age")
    found.append(Constant("AGE_PER_MS", "UDINT", str(round(1 / age.scale)), "raw numbers a millisecond"))
    for name, of in (("position_mm", "x"), ("angle_deg", "a"), ("quaternion", "qw")):
        found.append(Constant(name.upper(), "LREAL", _real(_register(block, of).scale)))
    for name, of in (("uncertainty_mm", "uncertainty_x"), ("uncertainty_deg", "uncertainty_a")):
        found.append(Constant(name.upper(), "LREAL", _real(_register(block, of).scale)))
    for name, of in (("least_mm", "x"), ("least_deg", "a")):
        found.append(Constant(name.upper(), "LREAL", _real(_least_known(_register(block, of))), "smallest known"))
    for name, of in (("most_uncertain_mm", "uncertainty_x"), ("most_uncertain_deg", "uncertainty_a")):
        found.append(Constant(name.upper(), "LREAL", _real(_largest_known(_register(block, of))), "largest known"))
    return found


def _state(register_map: RegisterMap) -> list[Constant]:
    block = register_map.block("state")
    names = {"heartbeat": "HEARTBEAT_WORD", "state": "STATE_WORD", "command_echo": "ECHO_WORD"}
    names |= {name: f"{name.upper()}_WORD" for name in ("command_state", "command_result", "command_detail")}
    return [_index(block, name, constant) for name, constant in names.items()]


def _latch(register_map: RegisterMap) -> list[Constant]:
    states = {row.name: row.value for row in register_map.choices["command_state"]}
    return [Constant(f"STATE_{name.upper()}", "WORD", _word(states[name])) for name in ("done", "failed")]


def _unit(register_map: RegisterMap) -> list[Constant]:
    identity, state, measured, latched = (
        register_map.block(name) for name in ("identity", "state", "measured", "latched")
    )
    requests = (("IDENTITY", identity.first, identity.last), ("POSE", state.first, measured.last))
    found = []
    for name, first, last in (*requests, ("COPY", latched.first, latched.last)):
        found.append(Constant(f"{name}_ADDRESS", "UINT", str(first)))
        found.append(Constant(f"{name}_QUANTITY", "UINT", str(last - first + 1)))
    found.append(Constant("POSE_IN_ANSWER", "INT", str(measured.first - state.first)))
    return [*found, Constant("COMMAND_ADDRESS", "UINT", str(register_map.block("command").first))]


SECTIONS: dict[str, Callable[[RegisterMap], list[Constant]]] = {
    "TripointIdentified.st": _identified,
    "TripointBlock.st": _block,
    "TripointState.st": _state,
    "TripointLatch.st": _latch,
    "TripointUnit.st": _unit,
}


def _register(block: Block, name: str) -> Register:
    return next(register for register in block.registers if register.name == name)


def _index(block: Block, name: str, constant: str = "") -> Constant:
    register = _register(block, name)
    return Constant(constant or name.upper(), "INT", str(register.address - block.first), str(register.address))


def _mask(register_map: RegisterMap, name: str) -> Constant:
    (bit,) = (row.value for row in register_map.bits["status"] if row.name == name)
    return Constant(name.upper(), "WORD", _word(1 << bit), f"bit {bit}")


def _constant(block: Block, name: str) -> int:
    """The raw number that the register always reads."""
    value = _register(block, name).constant
    if isinstance(value, float):
        return int.from_bytes(struct.pack(">f", value), "big")
    if value is None:
        raise MapError(f"{block.name}.{name} has no constant")
    return value


def _least_known(register: Register) -> float:
    """The smallest number but one, times the scale: the smallest stands for unknown."""
    return (1 - (1 << (SIGNED_BITS[register.type] - 1))) * register.scale


def _largest_known(register: Register) -> float:
    return ((1 << 16 * register.words) - 2) * register.scale


def _word(value: int) -> str:
    return f"16#{value:04X}"


def _real(value: float) -> str:
    """Digits that every compiler takes: a point, and no exponent."""
    text = f"{value:.9f}".rstrip("0")
    return text + "0" if text.endswith(".") else text
