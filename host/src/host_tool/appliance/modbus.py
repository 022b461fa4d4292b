"""Modbus TCP to one unit; the only module that knows pymodbus."""

import logging
from collections.abc import Callable
from enum import Enum
from types import TracebackType
from typing import Self

from pymodbus.client import ModbusTcpClient
from pymodbus.exceptions import ConnectionException, ModbusException
from pymodbus.pdu import ModbusPDU

from host_tool.appliance.address import Address
from host_tool.errors import DeviceError

UNIT_ID = 255  # any is answered; 255 is what a device that is no gateway should be called
MAX_WORDS = 125  # of one read, by the Modbus specification

_EXCEPTIONS = {1: "illegal function", 2: "illegal data address", 3: "illegal data value", 4: "device failure"}


class Table(Enum):
    """Where a client looks: FC 4 reads input registers, FC 3 holding registers."""

    INPUT = "input"
    HOLDING = "holding"


class RefusedError(DeviceError):
    """The unit answered with a Modbus exception; `exception_code` is its number."""

    def __init__(self, what: str, exception_code: int) -> None:
        reason = _EXCEPTIONS.get(exception_code, "unknown reason")
        super().__init__(
            "E-NET-04",
            f"{what} refused with exception {exception_code:02d} ({reason})",
            "check that this is a Tripoint and its firmware is not older than host-tool",
        )
        self.exception_code = exception_code


class ModbusLink:
    """One connection. Every wait is limited by `timeout_s`; nothing is retried behind the caller's back.

    All methods raise DeviceError: E-NET-01 not reachable, E-NET-02 no answer in time, E-NET-03 connection
    closed or answer not understood, E-NET-04 (RefusedError) a Modbus exception.
    """

    def __init__(self, address: Address, timeout_s: float) -> None:
        logging.getLogger("pymodbus").setLevel(logging.CRITICAL)  # its failures come as our errors
        self.address = address
        self._timeout_s = timeout_s
        self._client = ModbusTcpClient(address.host, port=address.port, timeout=timeout_s, retries=0)

    def __enter__(self) -> Self:
        if not self._client.connect():
            raise DeviceError(
                "E-NET-01",
                f"no unit answers at {self.address}",
                "check address, port, cable and that tripointd runs, or name another with --device",
            )
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._client.close()

    def read(self, table: Table, address: int, count: int) -> tuple[int, ...]:
        """`count` registers from the wire address `address`, in one request."""
        ask = self._client.read_input_registers if table is Table.INPUT else self._client.read_holding_registers
        what = f"reading {table.value} registers {address} to {address + count - 1}"
        answer = self._exchange(what, lambda: ask(address, count=count, device_id=UNIT_ID))
        if len(answer.registers) != count:
            raise _garbled(what, f"{len(answer.registers)} registers came back")
        return tuple(answer.registers)

    def write(self, address: int, value: int) -> None:
        """One holding register, with FC 6."""
        self._exchange(
            f"writing register {address}",
            lambda: self._client.write_register(address, value, device_id=UNIT_ID),
        )

    def device_identification(self, level: int = 1) -> dict[int, str]:
        """FC 43/14: object number to text; `level` 1 basic, 2 regular, 3 extended."""
        what = "reading the device identification"
        answer = self._exchange(what, lambda: self._client.read_device_information(read_code=level, device_id=UNIT_ID))
        objects: dict[int, bytes] = getattr(answer, "information", {})
        return {number: value.decode("utf-8", "replace") for number, value in objects.items()}

    def _exchange(self, what: str, request: Callable[[], ModbusPDU]) -> ModbusPDU:
        try:
            answer = request()
        except ConnectionException as error:
            raise DeviceError(
                "E-NET-03",
                f"{what}: the connection to {self.address} was closed",
                "check that tripointd still runs and modbus.allowed_clients admits this computer",
            ) from error
        except ModbusException as error:
            raise DeviceError(
                "E-NET-02",
                f"{what}: no answer from {self.address} within {self._timeout_s:g} s",
                "check that it is a Modbus TCP server, or give a longer --timeout",
            ) from error
        except (OSError, ValueError, IndexError) as error:
            self._client.close()
            raise _garbled(what, str(error)) from error
        if answer.isError():
            raise RefusedError(what, int(answer.exception_code))
        return answer


def _garbled(what: str, why: str) -> DeviceError:
    return DeviceError(
        "E-NET-03", f"{what}: the answer makes no sense ({why})", "check that this is a Modbus TCP server"
    )
