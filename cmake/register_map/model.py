"""The register map as values: reads registers.toml and expands blocks that are like another and repeated registers."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

FORMAT = "tripoint-registers/1"
WORDS = {"u16": 1, "i16": 1, "u32": 2, "i32": 2, "f32": 2, "u64": 4}


class MapError(Exception):
    """registers.toml is not a register map; the message says where and why."""


@dataclass(frozen=True, slots=True)
class Register:
    """One row of the map; `address` is that of its first place, when it repeats."""

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
    def words(self) -> int:
        """How many registers one value fills."""
        return WORDS[self.type]

    @property
    def places(self) -> list[int]:
        """The address of each repetition."""
        return [self.address + i * self.stride for i in range(self.repeat)]


@dataclass(frozen=True, slots=True)
class Block:
    """Registers that belong together; `own` are those written in the file, `registers` all of them."""

    name: str
    first: int
    last: int
    title: str
    text: str
    like: str | None
    own: tuple[Register, ...]
    registers: tuple[Register, ...]


@dataclass(frozen=True, slots=True)
class Name:
    """A bit or a number with its name and meaning."""

    value: int
    name: str
    meaning: str


@dataclass(frozen=True, slots=True)
class Server:
    """What a client's connection must keep to."""

    most_connections: int
    frame_ms: int
    write_ms: int
    idle_ms: int
    pace_us: int
    burst_ms: int


@dataclass(frozen=True, slots=True)
class RegisterMap:
    """The whole contract."""

    major: int
    minor: int
    image_length: int
    mirror_at: int
    server: Server
    blocks: tuple[Block, ...]
    bits: dict[str, tuple[Name, ...]]
    choices: dict[str, tuple[Name, ...]]

    def block(self, name: str) -> Block:
        """The block of that name."""
        return next(block for block in self.blocks if block.name == name)


def load(path: Path) -> RegisterMap:
    """Read the map; raises MapError when the file is not one."""
    try:
        return from_document(tomllib.loads(path.read_text(encoding="utf-8")))
    except tomllib.TOMLDecodeError as error:
        raise MapError(f"{path}: {error}") from error


def from_document(document: dict[str, Any]) -> RegisterMap:
    """Turn the parsed file into values; raises MapError for unknown or missing keys."""
    if document.get("format") != FORMAT:
        raise MapError(f'format must be "{FORMAT}"')
    try:
        blocks: list[Block] = []
        for table in document["blocks"]:
            blocks.append(_block(table, blocks))
        return RegisterMap(
            major=document["major"],
            minor=document["minor"],
            image_length=document["image_length"],
            mirror_at=document["mirror_at"],
            server=_server(document["server"]),
            blocks=tuple(blocks),
            bits={t["name"]: _names(t["bits"], "bit") for t in document.get("bits", [])},
            choices={t["name"]: _names(t["choices"], "value") for t in document.get("choices", [])},
        )
    except KeyError as error:
        raise MapError(f"key {error} is missing") from error


def _server(table: dict[str, Any]) -> Server:
    try:
        return Server(**table)
    except TypeError as error:
        raise MapError(f"server: {error}") from error


def _names(rows: list[dict[str, Any]], number: str) -> tuple[Name, ...]:
    return tuple(Name(row[number], row["name"], row["meaning"]) for row in rows)


def _register(row: dict[str, Any], block: str) -> Register:
    if row.get("type") not in WORDS:
        raise MapError(f"block {block}: type {row.get('type')!r} of {row.get('name')!r} is none of {', '.join(WORDS)}")
    try:
        return Register(**row)
    except TypeError as error:
        raise MapError(f"block {block}, register {row.get('name')!r}: {error}") from error


def _block(table: dict[str, Any], before: list[Block]) -> Block:
    name = table["name"]
    own = tuple(_register(row, name) for row in table.get("registers", []))
    inherited: tuple[Register, ...] = ()
    if "like" in table:
        model = next((block for block in before if block.name == table["like"]), None)
        if model is None:
            raise MapError(f"block {name} is like {table['like']!r}, which does not come before it")
        taken = {register.address for register in own}
        moved = (replace(r, address=r.address + table["first"] - model.first) for r in model.registers)
        inherited = tuple(register for register in moved if register.address not in taken)
    registers = tuple(sorted(inherited + own, key=lambda register: register.address))
    return Block(name, table["first"], table["last"], table["title"], table["text"], table.get("like"), own, registers)
