"""One connection: what arrives, and what every kind of failure becomes."""

import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from host.fake_unit import LATE_S, FakeUnit, Manner, fake_unit
from host.register_image import measuring_image

from host_tool.appliance.address import Address, address_from
from host_tool.appliance.modbus import ModbusLink, RefusedError, Table
from host_tool.appliance.unit import Unit, open_unit, wait_until_answering
from host_tool.clock import MonotonicClock
from host_tool.errors import DeviceError, ExitCode, UsageError

TIMEOUT_S = 0.3


@contextmanager
def linked(manner: Manner = Manner.WELL) -> Iterator[tuple[FakeUnit, ModbusLink]]:
    with fake_unit(measuring_image, manner) as unit, ModbusLink(address_from(unit.device), TIMEOUT_S) as link:
        yield unit, link


def unused_address() -> Address:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return Address("127.0.0.1", probe.getsockname()[1])


@pytest.mark.parametrize("table", list(Table))
def test_both_tables_hold_the_image(table: Table) -> None:
    with linked() as (_, link):
        assert link.read(table, 4, 2) == (0x0102, 0x0304)


def test_the_mirror_is_read_at_2000() -> None:
    with linked() as (_, link):
        assert link.read(Table.HOLDING, 2004, 2) == (0x0304, 0x0102)


def test_a_register_is_written() -> None:
    with linked() as (unit, link):
        link.write(1000, 0x0101)
        assert unit.written == [(1000, 0x0101)]


def test_the_device_identification_is_read() -> None:
    with linked() as (_, link):
        assert link.device_identification() == {0: "Tripoint"}


def test_a_refusal_carries_its_exception() -> None:
    with linked() as (_, link), pytest.raises(RefusedError, match="E-NET-04") as caught:
        link.read(Table.INPUT, 1900, 4)
    assert caught.value.exception_code == 2
    assert caught.value.exit_code == ExitCode.NO_DEVICE


@pytest.mark.parametrize(
    ("manner", "code"),
    [
        (Manner.SILENT, "E-NET-02"),
        (Manner.NOISE, "E-NET-0[23]"),
        (Manner.CLOSING, "E-NET-03"),
        (Manner.SHORT, "E-NET-03"),
        (Manner.REFUSING, "E-NET-04"),
    ],
)
def test_a_server_that_misbehaves_is_named_in_time(manner: Manner, code: str) -> None:
    with linked(manner) as (_, link):
        started_s = time.monotonic()
        with pytest.raises(DeviceError, match=code):
            link.read(Table.INPUT, 32, 116)
        # pymodbus waits its timeout for data, then once more for the rest of what may be a split answer.
        assert time.monotonic() - started_s < 3 * TIMEOUT_S


def test_a_late_answer_is_not_taken_for_that_of_the_next_request() -> None:
    with linked(Manner.LATE) as (_, link):
        with pytest.raises(DeviceError, match="E-NET-02"):
            link.read(Table.INPUT, 0, 2)
        time.sleep(LATE_S)
        assert link.read(Table.INPUT, 4, 2) == (0x0102, 0x0304)


def test_where_nobody_listens_no_unit_answers() -> None:
    with pytest.raises(DeviceError, match="E-NET-01"), open_unit(unused_address(), TIMEOUT_S):
        pass


def test_waiting_for_a_unit_has_an_end() -> None:
    started_s = time.monotonic()
    with pytest.raises(DeviceError, match="E-NET-01"):
        wait_until_answering(unused_address(), TIMEOUT_S, 0.3, MonotonicClock())
    assert 0.3 <= time.monotonic() - started_s < 2.0


def test_waiting_ends_when_a_unit_answers() -> None:
    with fake_unit(measuring_image) as unit:
        wait_until_answering(address_from(unit.device), TIMEOUT_S, 0.0, MonotonicClock())


def test_another_modbus_server_is_no_tripoint() -> None:
    image = measuring_image()
    image.put(0, "H", 7)
    with (
        fake_unit(lambda: image) as unit,
        pytest.raises(DeviceError, match="E-DEV-01"),
        open_unit(address_from(unit.device), TIMEOUT_S),
    ):
        pass


def test_a_unit_gives_its_blocks_as_values() -> None:
    with linked() as (_, link):
        unit = Unit(link)
        answer = unit.read_pose()
        assert (answer.state.heartbeat, answer.pose.position_mm) == (99, (-12.345, 6.789, 400.001))
        assert [point.identity for point in unit.read_points()] == [1]
        assert unit.read_health().timing.latency_p99_us == 980


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("unit", Address("unit", 1502)),
        ("10.0.0.5:502", Address("10.0.0.5", 502)),
        ("::1", Address("::1", 1502)),
        ("[::1]:502", Address("::1", 502)),
        ("[fe80::1]", Address("fe80::1", 1502)),
    ],
)
def test_a_device_is_host_and_port(text: str, address: Address) -> None:
    assert address_from(text) == address


@pytest.mark.parametrize("text", ["", ":502", "unit:", "unit:0", "unit:65536", "unit:http", "unit:-1", "[::1]x"])
def test_what_is_no_device_is_refused(text: str) -> None:
    with pytest.raises(UsageError, match="E-USE-01"):
        address_from(text)
