"""The options that every command has."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from typing import Any, TypeVar

import click

from host_tool.appliance.address import Address, address_from

R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Common:
    """--device, --timeout and --json."""

    address: Address
    timeout_s: float
    as_json: bool


def common_options(command: Callable[..., R]) -> Callable[..., R]:
    """Gives a command --device, --timeout and --json, handed over as its first argument."""

    @click.option("--device", default="127.0.0.1:1502", show_default=True, metavar="HOST[:PORT]", help="The unit.")
    @click.option(
        "--timeout",
        default=2.0,
        show_default=True,
        type=click.FloatRange(0.05, 60.0),
        metavar="SECONDS",
        help="Longest wait for one answer.",
    )
    @click.option("--json", "as_json", is_flag=True, help="Data as JSON.")
    @wraps(command)
    def with_common(device: str, timeout: float, as_json: bool, **options: Any) -> R:
        return command(Common(address_from(device), timeout, as_json), **options)

    return with_common
