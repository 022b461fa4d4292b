"""The probe: which of all client settings read right, and what to change in one that does not."""

import pytest
from host.register_image import measuring_image

from host_tool.appliance.modbus import RefusedError, Table
from host_tool.contract.words import WordOrder
from host_tool.diagnostics.plc_probe import ClientSetting, change_for, reading_for, readings_of
from host_tool.errors import DeviceError

RIGHT = {(WordOrder.ABCD, 0, 0), (WordOrder.CDAB, 2000, 0)}


class Registers:
    """An image without a network; `tables` are those it knows."""

    def __init__(self, tables: tuple[Table, ...] = tuple(Table)) -> None:
        self._image = measuring_image()
        self._tables = tables

    def read(self, table: Table, address: int, count: int) -> tuple[int, ...]:
        if table not in self._tables:
            raise RefusedError("reading", 1)
        words = self._image.words if address < 1000 else self._image.mirrored()
        return tuple(words[address % 2000 : address % 2000 + count])


def test_exactly_the_settings_of_the_published_map_read_right() -> None:
    readings = readings_of(Registers())
    right = [reading.setting for reading in readings if reading.right]
    assert {(setting.word_order, setting.base, setting.offset) for setting in right} == RIGHT
    assert len(right) == len(RIGHT) * len(Table)


@pytest.mark.parametrize(
    ("setting", "change"),
    [
        (ClientSetting(), None),
        (ClientSetting(WordOrder.CDAB, base=2000), None),
        (ClientSetting(WordOrder.CDAB), "set the client's word order to abcd or add 2000 to every address"),
        (ClientSetting(offset=1), "enter every address plus 1, since the client sends one less"),
        (
            ClientSetting(WordOrder.ABCD, base=2000),
            "use the addresses of the map as they are or set the client's word order to cdab",
        ),
    ],
)
def test_the_smallest_change_is_named(setting: ClientSetting, change: str | None) -> None:
    readings = readings_of(Registers())
    assert change_for(reading_for(setting, readings), readings) == change


@pytest.mark.parametrize(("offset", "wire_address"), [(0, 2004), (1, 2003)])
def test_a_client_that_counts_from_1_asks_one_register_lower(offset: int, wire_address: int) -> None:
    assert ClientSetting(base=2000, offset=offset).wire_address == wire_address


def test_a_client_with_two_faults_is_told_both() -> None:
    readings = readings_of(Registers())
    change = change_for(reading_for(ClientSetting(WordOrder.CDAB, offset=1), readings), readings)
    assert change is not None
    assert "word order to abcd and enter every address plus 1" in change


def test_a_table_that_a_gateway_hides_is_named_with_its_exception() -> None:
    readings = readings_of(Registers(tables=(Table.INPUT,)))
    reading = reading_for(ClientSetting(), readings)
    assert (reading.right, reading.refused) == (False, "exception 01")
    assert change_for(reading, readings) == "read input registers"


def test_a_server_without_the_test_registers_is_no_tripoint() -> None:
    registers = Registers()
    registers._image.put(4, "I", 0)
    with pytest.raises(DeviceError, match="E-PLC-01"):
        readings_of(registers)
