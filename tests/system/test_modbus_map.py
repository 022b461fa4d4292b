"""The map as other people's Modbus clients see it: pymodbus and mbpoll, each with its own decoding."""

import subprocess
from collections.abc import Iterator

import pytest
from pymodbus.client import ModbusTcpClient
from pymodbus.pdu import ModbusPDU
from system.daemon import Daemon, daemon, tool

TYPES = ModbusTcpClient.DATATYPE
UNIT_ID = 255
MBPOLL_TYPES = {"input": "3", "holding": "4"}


@pytest.fixture(scope="module")
def unit(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    with daemon(tmp_path_factory.mktemp("daemon") / "log") as running:
        yield running


@pytest.fixture
def client(unit: Daemon) -> Iterator[ModbusTcpClient]:
    with ModbusTcpClient("127.0.0.1", port=unit.port, timeout=2.0, retries=0) as connected:
        yield connected


def read(client: ModbusTcpClient, table: str, address: int, count: int) -> ModbusPDU:
    ask = client.read_input_registers if table == "input" else client.read_holding_registers
    return ask(address, count=count, device_id=UNIT_ID)


@pytest.mark.parametrize("table", ["input", "holding"])
def test_both_tables_name_a_tripoint_of_map_1(client: ModbusTcpClient, table: str) -> None:
    assert read(client, table, 0, 4).registers == [0x5450, 1, 2, 1000]


@pytest.mark.parametrize("table", ["input", "holding"])
@pytest.mark.parametrize(("base", "word_order"), [(0, "big"), (2000, "little")])
def test_a_client_of_either_word_order_reads_the_test_values(
    client: ModbusTcpClient, table: str, base: int, word_order: str
) -> None:
    words = read(client, table, base + 4, 4).registers
    order: dict[str, str] = {"word_order": word_order}
    assert client.convert_from_registers(words[:2], TYPES.UINT32, **order) == 0x01020304  # type: ignore[arg-type]
    assert client.convert_from_registers(words[2:], TYPES.FLOAT32, **order) == 123456.0  # type: ignore[arg-type]


@pytest.mark.parametrize("unit_id", [0, 1, 247, 255])
def test_any_unit_id_is_answered(client: ModbusTcpClient, unit_id: int) -> None:
    assert client.read_input_registers(0, count=1, device_id=unit_id).registers == [0x5450]


def test_the_device_identification_names_vendor_product_and_map(client: ModbusTcpClient) -> None:
    basic = client.read_device_information(read_code=1, device_id=UNIT_ID).information  # type: ignore[attr-defined]
    assert set(basic) == {0, 1, 2}
    assert all(basic.values())
    extended = client.read_device_information(read_code=4, object_id=0x80, device_id=UNIT_ID)
    assert extended.information[0x80] == b"1.2"  # type: ignore[attr-defined]


@pytest.mark.parametrize(("address", "count"), [(999, 2), (1000, 2), (1001, 1), (1999, 1), (2999, 2), (3000, 1)])
def test_a_read_outside_the_image_is_exception_02(client: ModbusTcpClient, address: int, count: int) -> None:
    answer = read(client, "holding", address, count)
    assert answer.isError()
    assert answer.exception_code == 2


def test_an_unknown_function_is_exception_01(client: ModbusTcpClient) -> None:
    answer = client.read_coils(0, count=1, device_id=UNIT_ID)
    assert answer.isError()
    assert answer.exception_code == 1


def test_only_the_command_register_can_be_written(client: ModbusTcpClient) -> None:
    assert client.write_register(110, 1, device_id=UNIT_ID).exception_code == 2
    assert not client.write_register(1000, 0, device_id=UNIT_ID).isError()


@pytest.mark.parametrize("table", ["input", "holding"])
@pytest.mark.parametrize(
    ("kind", "options", "answer"),
    [
        ("int", ("-B", "-r", "4"), "[4]: \t16909060"),  # 0x01020304
        ("int", ("-r", "2004"), "[2004]: \t16909060"),
        ("float", ("-B", "-r", "6"), "[6]: \t123456"),
        ("float", ("-r", "2006"), "[2006]: \t123456"),
    ],
)
def test_mbpoll_reads_the_test_values(
    unit: Daemon, table: str, kind: str, options: tuple[str, ...], answer: str
) -> None:
    asked = [tool("mbpoll"), "-m", "tcp", "-0", "-1", "-q", "-c", "1", "-p", str(unit.port), *options]
    asked += ["-t", f"{MBPOLL_TYPES[table]}:{kind}", "127.0.0.1"]
    told = subprocess.run(asked, capture_output=True, text=True, timeout=10.0, check=True)
    assert answer in told.stdout
