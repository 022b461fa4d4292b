"""A Tripoint unit: its blocks as values, checked to be one we understand before anything else is read."""

from collections.abc import Iterator
from contextlib import contextmanager

from host_tool.appliance.address import Address
from host_tool.appliance.modbus import ModbusLink, Table
from host_tool.clock import Clock
from host_tool.contract import decode
from host_tool.contract.blocks import Answer, Health, Identity, Point
from host_tool.contract.register_map import register_map
from host_tool.errors import DeviceError

RETRY_S = 0.25


class Unit:
    """Reads input registers with the most significant word first."""

    def __init__(self, link: ModbusLink) -> None:
        self.link = link
        self.identity = self.read_identity()

    def read_identity(self) -> Identity:
        """Registers 0 to 31; raises DeviceError E-DEV-01 no Tripoint, E-DEV-02 a map we do not know."""
        return decode.identity_of(self._read("identity")[0])

    def read_pose(self) -> Answer:
        """State and integer pose from one request; raises DeviceError E-DEV-03 when torn."""
        state, measured = self._read("state", "measured")
        return Answer(decode.state_of(state), decode.pose_of(measured))

    def read_points(self) -> tuple[Point, ...]:
        """The points of the newest verdict; raises DeviceError E-DEV-03 when torn."""
        return decode.points_of(self._read("points")[0])

    def read_health(self) -> Health:
        """Cameras and timing."""
        return decode.health_of(*self._read("left_camera", "right_camera", "timing"))

    def _read(self, *names: str) -> list[decode.BlockWords]:
        """Blocks, in rising order, from one request, so that they belong together."""
        blocks = [register_map().blocks[name] for name in names]
        first, last = blocks[0].first, blocks[-1].last
        words = self.link.read(Table.INPUT, first, last - first + 1)
        return [decode.BlockWords(block, words[block.first - first : block.last - first + 1]) for block in blocks]


@contextmanager
def open_unit(address: Address, timeout_s: float) -> Iterator[Unit]:
    """Connects and checks; raises DeviceError (E-NET of appliance/modbus.py, E-DEV of Unit)."""
    with ModbusLink(address, timeout_s) as link:
        yield Unit(link)


def wait_until_answering(address: Address, timeout_s: float, patience_s: float, clock: Clock) -> None:
    """Returns once a unit answers; after `patience_s` the last DeviceError is raised."""
    deadline_s = clock.now_s() + patience_s
    while True:
        try:
            with open_unit(address, timeout_s):
                return
        except DeviceError:
            if clock.now_s() >= deadline_s:
                raise
        clock.sleep(RETRY_S)
