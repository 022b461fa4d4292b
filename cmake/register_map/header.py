"""The register map as a C++ header: typed fields, the table of types, enumerations."""

from __future__ import annotations

from dataclasses import asdict

from register_map.model import Block, Name, Register, RegisterMap

CPP_TYPES = {
    "u16": "std::uint16_t",
    "i16": "std::int16_t",
    "u32": "std::uint32_t",
    "i32": "std::int32_t",
    "u64": "std::uint64_t",
    "f32": "float",
}
SIGNED_BITS = {"i16": 16, "i32": 32}
LARGEST = {"u16": 0xFFFF, "i16": 0x7FFF, "u32": 0xFFFFFFFF, "i32": 0x7FFFFFFF, "u64": 0xFFFFFFFFFFFFFFFF}
PREFIX = """\
// Made from firmware/contract/registers.toml by cmake/registers: change that file, not this one.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "serve/field.h"

namespace tripoint::registers {
"""


def header(register_map: RegisterMap) -> str:
    """The whole header."""
    lines = [PREFIX]
    for name in ("major", "minor", "image_length", "mirror_at"):
        lines.append(f"inline constexpr std::uint16_t {_constant(name)} = {getattr(register_map, name)};")
    lines += ["", "/// What a client's connection must keep to.", "namespace server {"]
    for name, value in asdict(register_map.server).items():
        lines.append(f"inline constexpr std::uint32_t {_constant(name)} = {value};")
    lines.append("}")
    for name, rows in register_map.bits.items():
        lines += _enumeration(f"{_pascal(name)}Bit", rows) + _bit_names(name, rows)
    for name, rows in register_map.choices.items():
        lines += _enumeration(_pascal(name), rows)
    for block in register_map.blocks:
        lines += _block(block)
    lines += _table(register_map)
    lines += ["", "}  // namespace tripoint::registers", ""]
    return "\n".join(lines)


def _pascal(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def _constant(name: str) -> str:
    return "k" + _pascal(name)


def _enumeration(name: str, rows: tuple[Name, ...]) -> list[str]:
    body = [f"  {_constant(row.name)} = {row.value},  ///< {row.meaning}" for row in rows]
    return ["", f"enum class {name} : std::uint16_t {{", *body, "};"]


def _bit_names(name: str, rows: tuple[Name, ...]) -> list[str]:
    body = [f'  {{{row.value}, "{row.name}"}},' for row in rows]
    return [f"inline constexpr std::array<BitName, {len(rows)}> {_constant(name)}Bits{{{{", *body, "}};"]


def _block(block: Block) -> list[str]:
    head = ["", f"/// {block.title}, {block.first} to {block.last}", f"namespace {block.name} {{"]
    place = [f"inline constexpr std::uint16_t kFirst = {block.first}, kLast = {block.last};"]
    fields = [_field(register) for register in block.registers]
    return head + place + fields + ["}"]


def _field(register: Register) -> str:
    cpp = CPP_TYPES[register.type]
    kind = "Field" if register.unknown is None else "OptionalField"
    values = [str(register.address), repr(float(register.scale)), _number(register, _highest(register))]
    if register.unknown is not None:
        values.append(_number(register, register.unknown))
    comment = f"{register.unit + ': ' if register.unit else ''}{register.meaning}"
    lines = f"inline constexpr {kind}<{cpp}> {_constant(register.name)}{{{', '.join(values)}}};  ///< {comment}"
    if register.constant is not None:
        lines += f"\ninline constexpr {cpp} {_constant(register.name)}Value = {_number(register, register.constant)};"
    return lines


def _highest(register: Register) -> int | float | str:
    if register.highest is not None:
        return register.highest
    if register.type == "f32":
        return "max"
    largest = LARGEST[register.type]
    return largest - 1 if register.unknown == largest else largest


def _number(register: Register, value: int | float | str) -> str:
    cpp = CPP_TYPES[register.type]
    if value == "nan":
        return "std::numeric_limits<float>::quiet_NaN()"
    if value == "max":
        return "std::numeric_limits<float>::max()"
    if register.type == "f32":
        return f"{float(value)}F"
    number = int(value)
    bits = SIGNED_BITS.get(register.type)
    if bits is not None and number == 1 << (bits - 1):
        return f"std::numeric_limits<{cpp}>::min()"
    if bits is not None and number > 1 << (bits - 1):
        number -= 1 << bits
    return f"{number}{'U' if register.type.startswith('u') else ''}{'LL' if register.type == 'u64' else ''}"


def _table(register_map: RegisterMap) -> list[str]:
    rows = [
        (place, register.words, f"{block.name}.{register.name}" + (f"_{i + 1}" if register.repeat > 1 else ""))
        for block in register_map.blocks
        if block.last < register_map.image_length
        for register in block.registers
        for i, place in enumerate(register.places)
    ]
    body = [f'  {{{address}, {words}, "{name}"}},' for address, words, name in sorted(rows)]
    return [
        "",
        "/// Every value of the image, by address.",
        f"inline constexpr std::array<Row, {len(body)}> kTable{{{{",
        *body,
        "}};",
    ]
