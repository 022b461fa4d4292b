"""Reads the unit's state and pose over Modbus TCP with nothing but the standard library.

It is written after the register map alone and shares no code with the product, so that it is a second opinion on it.
"""

import socket
import struct
from dataclasses import dataclass

READ_HOLDING = 3
FIRST, COUNT = 32, 116  # state and pose in one answer, as a PLC reads it
POSITION_VALID = 1 << 2
LEFT_LOST = 1 << 1
RIGHT_LOST = 1 << 2
UNKNOWN_POSITION = -0x80000000
UNKNOWN_UNCERTAINTY = 0xFFFFFFFF


@dataclass(frozen=True, slots=True)
class Reading:
    """One consistent answer: registers 32 to 147."""

    heartbeat: int
    status: int
    faults: int
    state: int
    sequence: int
    pose_status: int
    pose_faults: int
    raw_position_um: tuple[int, int, int]
    raw_uncertainty_nm: tuple[int, int, int]
    points: int

    @property
    def valid(self) -> bool:
        """Both the unit and this very pose say that the position may be used."""
        return bool(self.status & self.pose_status & POSITION_VALID)

    @property
    def position_unknown(self) -> bool:
        return self.raw_position_um == (UNKNOWN_POSITION,) * 3 and self.raw_uncertainty_nm == (UNKNOWN_UNCERTAINTY,) * 3

    @property
    def position_mm(self) -> tuple[float, float, float]:
        x, y, z = self.raw_position_um
        return (x / 1000, y / 1000, z / 1000)

    @property
    def uncertainty_mm(self) -> tuple[float, float, float]:
        """Expanded, k = 2."""
        x, y, z = self.raw_uncertainty_nm
        return (x / 1e6, y / 1e6, z / 1e6)


def reading_from(words: tuple[int, ...]) -> Reading:
    """Decodes the registers; raises ValueError when the pose block is torn."""
    register = dict(enumerate(words, FIRST))

    def int32s(at: int) -> tuple[int, int, int]:
        return struct.unpack(">3i", struct.pack(">6H", *(register[at + i] for i in range(6))))

    if register[100] != register[147]:
        raise ValueError(f"torn pose block: sequence {register[100]} first, {register[147]} last")
    uncertainty = struct.unpack(">3I", struct.pack(">3i", *int32s(130)))
    return Reading(
        heartbeat=register[32],
        status=register[33],
        faults=register[34],
        state=register[36],
        sequence=register[100],
        pose_status=register[101],
        pose_faults=register[102],
        raw_position_um=int32s(110),
        raw_uncertainty_nm=uncertainty,
        points=register[143],
    )


def read_registers(port: int, first: int, count: int) -> tuple[int, ...]:
    """One request on a connection of its own. Raises OSError or ValueError."""
    request = struct.pack(">HHHBBHH", 1, 0, 6, 255, READ_HOLDING, first, count)
    with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
        connection.sendall(request)
        answer = connection.makefile("rb").read(9 + 2 * count)
    if len(answer) != 9 + 2 * count or answer[7] != READ_HOLDING:
        raise ValueError(f"unexpected answer {answer.hex()}")
    return struct.unpack(f">{count}H", answer[9:])


def read_pose(port: int) -> Reading:
    return reading_from(read_registers(port, FIRST, COUNT))
