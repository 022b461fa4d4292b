"""The options that every command has."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from typing import Any, TypeVar

import click

from host_tool.appliance.address import Address, address_from

R = TypeVar("R")


class Finite(click.FloatRange):
    """A range without its "nan", which no limit refuses."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        number = super().convert(value, param, ctx)
        if math.isnan(number):
            self.fail(f"{value} is not a number.", param, ctx)
        return number


@dataclass(frozen=True, slots=True)
class Common:
    """--device, --timeout and --json."""

    address: Address
    timeout_s: float
    as_json: bool


def common_options(command: Callable[..., R]) -> Callable[..., R]:
    """Gives a command --device, --timeout and --json, handed over as its first argument."""

    @click.option(
        "--device",
        default="127.0.0.1:1502",
        show_default=True,
        metavar="HOST[:PORT]",
        help="The unit's Modbus server; IPv6 as [::1]:502; the port is 1502 when left away.",
    )
    @click.option(
        "--timeout",
        default=2.0,
        show_default=True,
        type=Finite(0.05, 60.0),
        metavar="SECONDS",
        help="Longest wait for one answer of the unit.",
    )
    @click.option("--json", "as_json", is_flag=True, help="Data as JSON, one object a line; unknown is null.")
    @wraps(command)
    def with_common(device: str, timeout: float, as_json: bool, **options: Any) -> R:
        return command(Common(address_from(device), timeout, as_json), **options)

    return with_common
