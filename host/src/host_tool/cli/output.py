"""Printing: data to stdout, messages to stderr, colour only in a terminal (rich obeys NO_COLOR)."""

import json
import math
import sys
from dataclasses import asdict, is_dataclass
from enum import Enum
from typing import Any

import click
from rich.console import Console


def terminal() -> Console:
    """A console on today's stdout; made anew because tests and pipes exchange stdout."""
    return Console(file=sys.stdout, highlight=False, soft_wrap=True)


def is_live(console: Console) -> bool:
    """Whether a picture can be redrawn in place."""
    return console.is_terminal and not console.is_dumb_terminal


def print_json(value: object) -> None:
    """One line; what is not a number (NaN) is null, since JSON has no word for it."""
    click.echo(json.dumps(plain(value), allow_nan=False))


def plain(value: Any) -> Any:
    """Dataclasses, enumerators and tuples as what JSON knows."""
    if is_dataclass(value) and not isinstance(value, type):
        return plain(asdict(value))
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def number(value: float | None, digits: int, unit: str = "") -> str:
    """Fixed digits with the unit, or a dash for what is not known."""
    if value is None:
        return "-"
    return f"{value:.{digits}f} {unit}".rstrip()


def identification(value: int, digits: int) -> str:
    """A number that a PLC compares: decimal, as it sees it, and in hex."""
    return f"{value} (0x{value:0{digits}X})"
