"""What a PLC with given client settings would read, proved with the word-order test registers of the unit."""

from dataclasses import dataclass, fields
from itertools import product
from typing import Protocol

from host_tool.appliance.modbus import RefusedError, Table
from host_tool.contract.words import WordOrder, float32, unsigned
from host_tool.errors import DeviceError

TEST_ADDRESS = 4  # a u32 at 4 and a float at 6
EXPECTED_U32 = 0x01020304
EXPECTED_F32 = 123456.0
BASES = (0, 2000)
OFFSETS = (0, 1)


class Registers(Protocol):
    """What the probe reads from: one Modbus connection."""

    def read(self, table: Table, address: int, count: int) -> tuple[int, ...]: ...


@dataclass(frozen=True, slots=True)
class ClientSetting:
    """How a PLC's Modbus client is set up.

    `base` is what the programmer adds to each address of the map; `offset` is what the client itself takes
    off before it sends (1 where its addresses count from 1).
    """

    word_order: WordOrder = WordOrder.ABCD
    table: Table = Table.HOLDING
    base: int = 0
    offset: int = 0

    @property
    def wire_address(self) -> int:
        """Where this client looks for the test registers."""
        return self.base + TEST_ADDRESS - self.offset


@dataclass(frozen=True, slots=True)
class Reading:
    """What a client with this setting gets; no values when the unit refused."""

    setting: ClientSetting
    u32: int | None
    f32: float | None
    refused: str | None = None

    @property
    def right(self) -> bool:
        """Both test values came out as the map says."""
        return self.u32 == EXPECTED_U32 and self.f32 == EXPECTED_F32


def every_setting() -> list[ClientSetting]:
    """All combinations, in the order in which a programmer would try them."""
    choices = product(OFFSETS, Table, BASES, WordOrder)
    return [ClientSetting(order, table, base, offset) for offset, table, base, order in choices]


def readings_of(registers: Registers) -> list[Reading]:
    """Reads every setting; raises DeviceError E-PLC-01 when none comes out right: then it is no Tripoint."""
    readings = [_reading(registers, setting) for setting in every_setting()]
    if not any(reading.right for reading in readings):
        raise DeviceError(
            "E-PLC-01",
            "no client setting reads the test registers right",
            "check that --device is a Tripoint and that no gateway changes what passes",
        )
    return readings


def change_for(reading: Reading, readings: list[Reading]) -> str | None:
    """The smallest change that makes this setting read right, alternatives with "or"; None when it already does."""
    if reading.right:
        return None
    right = [other.setting for other in readings if other.right]
    fewest = min(len(_differences(reading.setting, setting)) for setting in right)
    ways = [_advice(reading.setting, other) for other in right if len(_differences(reading.setting, other)) == fewest]
    return " or ".join(ways)


def reading_for(setting: ClientSetting, readings: list[Reading]) -> Reading:
    """The one reading of this setting."""
    return next(reading for reading in readings if reading.setting == setting)


def _reading(registers: Registers, setting: ClientSetting) -> Reading:
    try:
        words = registers.read(setting.table, setting.wire_address, 4)
    except RefusedError as error:
        return Reading(setting, None, None, f"exception {error.exception_code:02d}")
    return Reading(setting, unsigned(words[:2], setting.word_order), float32(words[2:], setting.word_order))


def _differences(one: ClientSetting, other: ClientSetting) -> list[str]:
    names = [field.name for field in fields(one)]
    return [name for name in names if getattr(one, name) != getattr(other, name)]


def _advice(setting: ClientSetting, target: ClientSetting) -> str:
    words = {
        "word_order": f"set the client's word order to {target.word_order.value}",
        "table": f"read {target.table.value} registers",
        "base": f"add {target.base} to every address" if target.base else "use the addresses of the map as they are",
        "offset": "enter every address plus 1, since the client sends one less"
        if setting.offset
        else "enter every address as it is",
    }
    return " and ".join(words[name] for name in _differences(setting, target))
