"""What must hold for a register map, whatever it contains."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict

from register_map.model import Block, Register, RegisterMap

LARGEST = {"u16": 0xFFFF, "i16": 0xFFFF, "u32": 0xFFFFFFFF, "i32": 0xFFFFFFFF, "u64": 0xFFFFFFFFFFFFFFFF}
COMMAND_BLOCK = "command"


def problems(register_map: RegisterMap) -> list[str]:
    """Everything that is wrong, one line each; empty for a sound map."""
    found: list[str] = []
    for block in register_map.blocks:
        found += _of_block(block, register_map)
        for register in block.registers:
            found += _of_register(register, block, register_map)
    found += _overlaps(register_map)
    found += _of_head(register_map)
    found += [
        f"server: {name} must be a whole number greater than 0"
        for name, value in asdict(register_map.server).items()
        if not (isinstance(value, int) and value > 0)
    ]
    found += _twice("block", [block.name for block in register_map.blocks])
    for kind, table in (("bits", register_map.bits), ("choices", register_map.choices)):
        for name, rows in table.items():
            found += _twice(f"name in {kind} {name}", [row.name for row in rows])
            found += _twice(f"number in {kind} {name}", [str(row.value) for row in rows])
    found += [
        f"bits {name}: bit {row.value} is outside 0 to 15"
        for name, rows in register_map.bits.items()
        for row in rows
        if not 0 <= row.value <= 15
    ]
    return found


def _of_block(block: Block, register_map: RegisterMap) -> Iterator[str]:
    outside = not 0 <= block.first <= block.last < register_map.image_length
    if outside and block.name != COMMAND_BLOCK:
        yield f"block {block.name}: {block.first} to {block.last} is outside the image"
    if block.like is not None:
        model = register_map.block(block.like)
        if model.last - model.first != block.last - block.first:
            yield f"block {block.name} is like {model.name} but not as long"
    yield from _twice(f"register in block {block.name}", [register.name for register in block.registers])
    ends = {register.name: register.address for register in block.registers}
    if "sequence" in ends and (ends["sequence"] != block.first or ends.get("sequence_end") != block.last):
        yield f"block {block.name} does not carry its sequence first and last"


def _of_register(register: Register, block: Block, register_map: RegisterMap) -> Iterator[str]:
    where = f"{block.name}.{register.name} at {register.address}"
    if not register.name.isidentifier() or register.name.lower() != register.name:
        yield f"{where}: the name is not snake_case"
    if register.address < block.first or register.places[-1] + register.words - 1 > block.last:
        yield f"{where}: {register.type} does not lie inside its block"
    if register.repeat < 1 or (register.repeat > 1 and register.stride < register.words):
        yield f"{where}: repeated every {register.stride} registers but {register.words} long"
    if not register.scale > 0:
        yield f"{where}: scale must be greater than 0"
    if not register.meaning or not register.since:
        yield f"{where}: meaning and since must say something"
    if register.bits is not None and register.bits not in register_map.bits:
        yield f"{where}: there are no bits {register.bits!r}"
    if register.choices is not None and register.choices not in register_map.choices:
        yield f"{where}: there are no choices {register.choices!r}"
    yield from _of_numbers(register, where)


def _of_numbers(register: Register, where: str) -> Iterator[str]:
    if register.type == "f32":
        if register.unknown not in (None, "nan"):
            yield f'{where}: unknown of a f32 is "nan"'
        if register.scale != 1:
            yield f"{where}: a f32 carries its unit itself, scale 1"
        return
    for key in ("unknown", "highest", "constant"):
        value = getattr(register, key)
        if value is not None and not (isinstance(value, int) and 0 <= value <= LARGEST[register.type]):
            yield f"{where}: {key} {value!r} is not a raw number of {register.type}"


def _overlaps(register_map: RegisterMap) -> Iterator[str]:
    taken: dict[int, str] = {}
    for block in register_map.blocks:
        for register in block.registers:
            name = f"{block.name}.{register.name}"
            for address in (place + word for place in register.places for word in range(register.words)):
                if address in taken:
                    yield f"register {address} belongs to {taken[address]} and to {name}"
                taken[address] = name


def _of_head(register_map: RegisterMap) -> Iterator[str]:
    """What a client reads of the map's version and length is what the head of the file says."""
    head = {"map_major": register_map.major, "map_minor": register_map.minor, "image_length": register_map.image_length}
    for register in register_map.block("identity").registers:
        said = head.get(register.name, register.constant)
        if register.constant != said:
            yield f"register identity.{register.name}: reads {register.constant}, but the map says {said}"


def _twice(what: str, names: list[str]) -> Iterator[str]:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            yield f"{what} {name!r} exists twice"
        seen.add(name)
