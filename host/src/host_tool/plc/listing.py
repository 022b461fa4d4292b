"""All registers as CSV, with the address as each way of counting writes it."""

import csv
import io
from collections.abc import Sequence

from host_tool.contract.register_map import Register, register_map
from host_tool.plc.requests import COMMAND, Request, command_register

COLUMNS = (
    "request",
    "name",
    "address",
    "address_least_word_first",
    "address_from_1",
    "input_register",
    "holding_register",
    "type",
    "registers",
    "unit",
    "scale",
    "unknown",
    "meaning",
)


def listing(requests: Sequence[Request]) -> str:
    """One row for each value; the command register, which alone is written, comes last."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(COLUMNS)
    for request in requests:
        for tag in request.tags:
            rows.writerow(_row(request.name, tag.name, tag.register))
    command = command_register()
    row = _row(COMMAND, f"{COMMAND}_{command.name}", command)
    row[COLUMNS.index("address_least_word_first")] = ""
    rows.writerow(row)
    return text.getvalue()


def _row(request: str, name: str, register: Register) -> list[str]:
    at = register.address
    places = (at, at + register_map().mirror_at, at + 1, 30001 + at, 40001 + at)
    unknown = "NaN" if register.unknown == "nan" else "" if register.unknown is None else f"0x{register.unknown:X}"
    values = (register.type, register.count, register.unit, f"{register.scale:g}", unknown, register.meaning)
    return [request, name, *(str(place) for place in places), *(str(value) for value in values)]
