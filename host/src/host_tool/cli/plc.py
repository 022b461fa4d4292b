"""host-tool plc: proving that a PLC reads the unit right, and files for its tool."""

from typing import Any

import click

from host_tool.appliance.modbus import Table
from host_tool.appliance.unit import open_unit
from host_tool.cli.options import Common, common_options
from host_tool.cli.output import print_json
from host_tool.cli.plc_export import export
from host_tool.contract.words import WordOrder
from host_tool.diagnostics.plc_probe import (
    EXPECTED_F32,
    EXPECTED_U32,
    ClientSetting,
    Reading,
    change_for,
    reading_for,
    readings_of,
)
from host_tool.errors import ExitCode


@click.group(epilog="Example: host-tool plc probe --word-order cdab")
def plc() -> None:
    """Prove that a PLC or robot controller reads right, and write files for its tool."""


plc.add_command(export)


@plc.command(epilog="Example: host-tool plc probe --word-order cdab --table holding --device 192.168.1.20:502")
@click.option(
    "--word-order",
    type=click.Choice([order.value for order in WordOrder]),
    help="How the client puts 32 bits together: abcd = most significant word first.",
)
@click.option(
    "--table",
    type=click.Choice([table.value for table in Table]),
    help="What the client reads: input = FC 4, holding = FC 3.",
)
@click.option(
    "--base",
    type=click.Choice(["0", "2000"]),
    help="What you add to each address of the map; from 2000 on the words are swapped.",
)
@click.option(
    "--offset", type=click.Choice(["0", "1"]), help="1 where the client counts from 1: it takes 1 off before it sends."
)
@common_options
def probe(common: Common, **given: str | None) -> ExitCode:
    """Say which settings of a Modbus client read right.

    Reads the test values in registers 4 to 7 as sixteen kinds of client would. Given your client's setting (options
    left away count as abcd, holding, 0 and 0), it judges that one, says what to change, and exits 1 when it would
    read wrong values.
    """
    with open_unit(common.address, common.timeout_s) as unit:
        readings = readings_of(unit.link)
    setting = _setting_from(given)
    change = None if setting is None else change_for(reading_for(setting, readings), readings)
    if common.as_json:
        print_json(_record(setting, change, readings))
    else:
        _print(setting, change, readings)
    return ExitCode.PASS if change is None else ExitCode.FAILED


def _setting_from(given: dict[str, str | None]) -> ClientSetting | None:
    """None when no option was given: then there is no setting to judge."""
    if not any(given.values()):
        return None
    return ClientSetting(
        WordOrder(given["word_order"] or WordOrder.ABCD.value),
        Table(given["table"] or Table.HOLDING.value),
        int(given["base"] or 0),
        int(given["offset"] or 0),
    )


def _record(setting: ClientSetting | None, change: str | None, readings: list[Reading]) -> dict[str, Any]:
    return {
        "expected": {"u32": EXPECTED_U32, "f32": EXPECTED_F32},
        "setting": setting,
        "right": None if setting is None else change is None,
        "change": change,
        "readings": [{**_plain_reading(reading), "right": reading.right} for reading in readings],
    }


def _plain_reading(reading: Reading) -> dict[str, Any]:
    return {"setting": reading.setting, "u32": reading.u32, "f32": reading.f32, "refused": reading.refused}


def _print(setting: ClientSetting | None, change: str | None, readings: list[Reading]) -> None:
    click.echo(f"expected: 4-5 as u32 0x{EXPECTED_U32:08X}, 6-7 as float {EXPECTED_F32}")
    click.echo("offset  table    base  word order  u32         float         reads")
    offset = 0 if setting is None else setting.offset
    for reading in readings:
        if reading.setting.offset == offset:
            click.echo(_row(reading) + ("  <- yours" if reading.setting == setting else ""))
    if setting is None:
        click.echo("Name your client's setting (--word-order, --table, --base, --offset) for a verdict on it.")
    elif change is None:
        click.echo("Your setting reads right.")
    else:
        click.echo(f"Your setting reads WRONG values. To change: {change}.")


def _row(reading: Reading) -> str:
    setting = reading.setting
    u32 = "-" if reading.u32 is None else f"0x{reading.u32:08X}"
    f32 = reading.refused or "-" if reading.f32 is None else f"{reading.f32:.7g}"
    mark = "right" if reading.right else "wrong"
    place = f"{setting.offset:<8}{setting.table.value:<9}{setting.base:<6}{setting.word_order.value:<12}"
    return f"{place}{u32:<12}{f32:<14}{mark}"
