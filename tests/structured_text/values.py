"""Values of Structured Text, each with its type. Nothing converts by itself and nothing wraps: that is an error."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

RANGES = {
    "BYTE": (0, 0xFF),
    "WORD": (0, 0xFFFF),
    "DWORD": (0, 0xFFFFFFFF),
    "INT": (-(1 << 15), (1 << 15) - 1),
    "UINT": (0, 0xFFFF),
    "DINT": (-(1 << 31), (1 << 31) - 1),
    "UDINT": (0, 0xFFFFFFFF),
    "TIME": (0, 0xFFFFFFFF),  # ms
}
BITS = ("BOOL", "BYTE", "WORD", "DWORD")
NUMBERS = ("INT", "UINT", "DINT", "UDINT", "LREAL")
WHOLE_LITERAL, REAL_LITERAL, BITS_LITERAL = "whole literal", "real literal", "16# literal"
TAKES = {
    WHOLE_LITERAL: ("INT", "UINT", "DINT", "UDINT"),
    REAL_LITERAL: ("LREAL",),
    BITS_LITERAL: ("BYTE", "WORD", "DWORD"),
}
COMPARISONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


class StructuredTextError(Exception):
    """What a compiler or the runtime of a PLC would refuse, or what they differ in."""


@dataclass(frozen=True, slots=True)
class Value:
    """A number, a bit, a time (ms) or a literal, which takes the type of what it meets."""

    type: str
    data: Any


@dataclass(slots=True)
class Array:
    """ARRAY[first..last] OF type."""

    type: str
    first: int
    items: list[Any]


@dataclass(slots=True)
class Structure:
    """A STRUCT or an instance of a function block: its members by name in lower case."""

    type: str
    members: dict[str, Any]


def of_type(value: Any, type_name: str) -> Value:
    """The value where `type_name` is wanted; only literals adapt."""
    if not isinstance(value, Value):
        raise StructuredTextError(f"{value.type} where {type_name} is wanted")
    if value.type != type_name and type_name not in TAKES.get(value.type, ()):
        raise StructuredTextError(f"{value.type} where {type_name} is wanted")
    return checked(type_name, value.data)


def checked(type_name: str, data: Any) -> Value:
    """A value inside the range of its type."""
    low, high = RANGES.get(type_name, (data, data))
    if not low <= data <= high:
        raise StructuredTextError(f"{data} is outside {type_name}")
    return Value(type_name, data)


def stored(value: Any, place: Any) -> Any:
    """What stands in `place` after `value` was assigned to it: a copy of the same type."""
    if isinstance(place, Value):
        return of_type(value, place.type)
    if isinstance(value, Array) and isinstance(place, Array):
        if (value.type, value.first, len(value.items)) != (place.type, place.first, len(place.items)):
            raise StructuredTextError(f"an array of {len(value.items)} where one of {len(place.items)} is wanted")
        return copied(value)
    if isinstance(value, Structure) and isinstance(place, Structure) and value.type == place.type:
        return copied(value)
    raise StructuredTextError(f"{value.type} where {place.type} is wanted")


def copied(value: Any) -> Any:
    """The same value in a place of its own."""
    if isinstance(value, Array):
        return Array(value.type, value.first, [copied(item) for item in value.items])
    if isinstance(value, Structure):
        return Structure(value.type, {name: copied(member) for name, member in value.members.items()})
    return value


def operation(sign: str, left: Any, right: Any) -> Value:
    """left sign right; both are evaluated, as every compiler may."""
    left, right = _alike(left, right)
    if sign in COMPARISONS:
        if left.type in BITS and sign not in ("=", "<>"):
            raise StructuredTextError(f"{sign} between {left.type}")
        return Value("BOOL", COMPARISONS[sign](left.data, right.data))
    if sign in ("AND", "OR", "XOR"):
        if left.type not in BITS:
            raise StructuredTextError(f"{sign} between {left.type}")
        return Value(
            left.type, {"AND": operator.and_, "OR": operator.or_, "XOR": operator.xor}[sign](left.data, right.data)
        )
    if left.type not in (*NUMBERS, WHOLE_LITERAL, REAL_LITERAL):
        raise StructuredTextError(f"{sign} between {left.type}")
    return checked(left.type, _arithmetic(sign, left, right))


def _alike(left: Any, right: Any) -> tuple[Value, Value]:
    if not isinstance(left, Value) or not isinstance(right, Value):
        raise StructuredTextError("arrays and structures can only be assigned")
    if left.type in TAKES and right.type not in TAKES:
        return of_type(left, right.type), right
    if right.type in TAKES and left.type not in TAKES:
        return left, of_type(right, left.type)
    return left, of_type(right, left.type) if left.type != right.type else right


def _arithmetic(sign: str, left: Value, right: Value) -> Any:
    if sign in ("/", "MOD") and right.data == 0:
        raise StructuredTextError("division by 0")
    if sign == "/" and left.type in ("LREAL", REAL_LITERAL):
        return left.data / right.data
    if sign in ("/", "MOD"):
        if left.data < 0 or right.data < 0:
            raise StructuredTextError(f"{sign} of a negative number")
        return left.data // right.data if sign == "/" else left.data % right.data
    return {"+": operator.add, "-": operator.sub, "*": operator.mul}[sign](left.data, right.data)


def negated(value: Value) -> Value:
    """-value, of a signed number or a literal."""
    if value.type not in ("INT", "DINT", "LREAL", WHOLE_LITERAL, REAL_LITERAL):
        raise StructuredTextError(f"- of {value.type}")
    return checked(value.type, -value.data)


def complement(value: Value) -> Value:
    """NOT value."""
    if value.type == "BOOL":
        return Value("BOOL", not value.data)
    if value.type in BITS:
        return Value(value.type, value.data ^ RANGES[value.type][1])
    raise StructuredTextError(f"NOT of {value.type}")


def converted(function: str, value: Any) -> Value | None:
    """X_TO_Y of a value of type X; None when the name is not of that form."""
    form = re.fullmatch(r"([A-Z]+)_TO_([A-Z]+)", function.upper())
    if form is None:
        return None
    source, target = form.groups()
    given = of_type(value, source)
    return checked(target, float(given.data) if target == "LREAL" else int(given.data))
