"""The register map as data, read from the one file that the unit's tables are made from too."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any

FORMAT = "tripoint-registers/1"
WORDS_OF = {"u16": 1, "i16": 1, "u32": 2, "i32": 2, "f32": 2, "u64": 4}


@dataclass(frozen=True, slots=True)
class Register:
    """One value of the map; the keys are explained in registers.toml."""

    address: int
    name: str
    type: str
    meaning: str
    since: str
    unit: str = ""
    scale: float = 1.0
    unknown: int | str | None = None
    highest: int | None = None
    constant: int | float | None = None
    choices: str | None = None
    bits: str | None = None
    repeat: int = 1
    stride: int = 0

    @property
    def count(self) -> int:
        """How many 16-bit registers it takes."""
        return WORDS_OF[self.type]


@dataclass(frozen=True, slots=True)
class Block:
    """Registers that are read together, by name."""

    name: str
    first: int
    last: int
    registers: Mapping[str, Register]

    @property
    def count(self) -> int:
        """How many 16-bit registers it takes."""
        return self.last - self.first + 1


@dataclass(frozen=True, slots=True)
class Meaning:
    """One bit, or one number of a choice: the machine's word for it and the people's."""

    number: int
    name: str
    meaning: str


@dataclass(frozen=True, slots=True)
class RegisterMap:
    """The whole map of one major version."""

    major: int
    minor: int
    image_length: int
    mirror_at: int
    blocks: Mapping[str, Block]
    bits: Mapping[str, tuple[Meaning, ...]]
    choices: Mapping[str, tuple[Meaning, ...]]

    def choice(self, group: str, number: int) -> str:
        """The name of a number; one from a newer unit is shown as the number, never hidden."""
        names = {meaning.number: meaning.name for meaning in self.choices[group]}
        return names.get(number, f"unknown ({number})")

    def bits_set(self, group: str, value: int) -> tuple[Meaning, ...]:
        """What the set bits mean; one from a newer unit is shown, never hidden."""
        known = {meaning.number: meaning for meaning in self.bits[group]}
        return tuple(
            known.get(bit, Meaning(bit, f"bit_{bit}", f"unknown bit {bit}")) for bit in range(16) if value >> bit & 1
        )


@cache
def register_map() -> RegisterMap:
    """The map that this host-tool was built with."""
    text = files(__package__).joinpath("registers.toml").read_text(encoding="utf-8")
    return map_from(tomllib.loads(text))


def map_from(table: Mapping[str, Any]) -> RegisterMap:
    """The parsed file as a map; ValueError for another format, TypeError or KeyError for a key we do not know."""
    if table["format"] != FORMAT:
        raise ValueError(f"registers.toml is {table['format']}, this reader knows {FORMAT}")
    blocks: dict[str, Block] = {}
    for entry in table["blocks"]:
        blocks[entry["name"]] = _block_from(entry, blocks)
    return RegisterMap(
        major=table["major"],
        minor=table["minor"],
        image_length=table["image_length"],
        mirror_at=table["mirror_at"],
        blocks=blocks,
        bits={group["name"]: _meanings(group["bits"], "bit") for group in table["bits"]},
        choices={group["name"]: _meanings(group["choices"], "value") for group in table["choices"]},
    )


def _block_from(entry: Mapping[str, Any], blocks: Mapping[str, Block]) -> Block:
    own = [Register(**register) for register in entry.get("registers", ())]
    taken = {register.address for register in own}
    registers = [register for one in own for register in _repeated(one)]
    if "like" in entry:
        model = blocks[entry["like"]]
        moved = (replace(r, address=r.address + entry["first"] - model.first) for r in model.registers.values())
        registers += [register for register in moved if register.address not in taken]
    return Block(entry["name"], entry["first"], entry["last"], {register.name: register for register in registers})


def _repeated(register: Register) -> list[Register]:
    if register.repeat == 1:
        return [register]
    return [
        replace(
            register,
            name=f"{register.name}_{i + 1}",
            address=register.address + i * register.stride,
            repeat=1,
        )
        for i in range(register.repeat)
    ]


def _meanings(entries: list[Mapping[str, Any]], key: str) -> tuple[Meaning, ...]:
    return tuple(Meaning(entry[key], entry["name"], entry["meaning"]) for entry in entries)
