"""The golden registers mean what they say, read with nothing but registers.toml."""

from __future__ import annotations

import json
import math
import struct
from typing import Any

import check_registers
import pytest
from register_map.model import Register, load

GOLDEN = check_registers.MAP.parent / "golden" / "position.json"
FORMATS = {"u16": ">H", "i16": ">h", "u32": ">I", "i32": ">i", "f32": ">f", "u64": ">Q"}


def registers() -> dict[str, tuple[int, Register]]:
    """Every value of the map by its full name, with its address."""
    return {
        f"{block.name}.{one.name}" + (f"_{i + 1}" if one.repeat > 1 else ""): (place, one)
        for block in load(check_registers.MAP).blocks
        for one in block.registers
        for i, place in enumerate(one.places)
    }


def value_of(register: Register, words: list[int]) -> float | None:
    """The value in its unit, None when unknown."""
    raw = b"".join(word.to_bytes(2, "big") for word in words)
    number = struct.unpack(FORMATS[register.type], raw)[0]
    if register.unknown == "nan":
        return None if math.isnan(number) else number
    if int.from_bytes(raw, "big") == register.unknown:
        return None
    return float(number * register.scale)


@pytest.mark.parametrize(
    "row", json.loads(GOLDEN.read_text(encoding="utf-8"))["registers"], ids=lambda row: row["name"]
)
def test_a_golden_register_reads_as_its_value(row: dict[str, Any]) -> None:
    address, register = registers()[row["name"]]
    assert address == row["address"]
    assert len(row["words"]) == register.words
    value = value_of(register, row["words"])
    if row["value"] is None:
        assert value is None
    else:
        assert value == pytest.approx(row["value"], rel=1e-7)  # half a step of float32 is 6e-8
