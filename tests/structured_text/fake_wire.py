"""A unit for the PLC's blocks without a network: an image whose heart beats, and the command register of the map."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from host.register_image import Image, measuring_image

from host_tool.appliance.modbus import RefusedError
from host_tool.errors import DeviceError

VALID = 0x600F  # ready, tracking, position and orientation valid, verified, mount watched
SETUP = 0xABCD
LATCHED_SEQUENCE = 4711
UNKNOWN_32, UNKNOWN_U32 = 0x80000000, 0xFFFFFFFF


def full_image(sequence: int = 70000, status: int = VALID) -> Image:
    """A valid pose with orientation: x, y, z = -12.345, 6.789, 400.001 mm, A, B, C = 10, -20.5, 179.999999 deg."""
    image = measuring_image(sequence, status)
    image.put(103, "H", 0)
    image.put(116, "i", 10_000_000, -20_500_000, 179_999_999)
    image.put(122, "i", 500_000_000, -500_000_000, 500_000_000, -500_000_000)
    image.put(136, "I", 30_000, 40_000, 50_000)
    return image


@dataclass(slots=True)
class FakeWire:
    """Answers as the map says; `spoil` changes the image before each answer."""

    spoil: Callable[[Image], None] = lambda _: None
    outcome: tuple[int, int] = (2, 0)  # command state and result of a latch
    latched_sequence: int = LATCHED_SEQUENCE
    beating: bool = True
    down: bool = False
    refusing: bool = False
    armed: bool = False  # after start the unit waits for a 0
    state: list[int] = field(default_factory=lambda: [0, 0, 0, 0])  # registers 40 to 43
    rival_word: int = 0  # a word that another client wrote after ours
    lag: int = 0  # readings for which a changed state is not seen yet
    shown: list[int] = field(default_factory=lambda: [0, 0, 0, 0])
    late: int = 0
    written: list[int] = field(default_factory=list)
    sequence: int = 70000

    def read(self, address: int, quantity: int) -> Sequence[int]:
        if self.down:
            raise DeviceError("E-NET-03", "the cable is out", "")
        if self.beating:
            self.sequence += 1
        image = full_image(self.sequence)
        image.put(32, "H", self.sequence & 0xFFFF)
        if address == 32 and self.shown != self.state:
            self.late += 1
            if self.late > self.lag:
                self.shown, self.late = self.state, 0
        image.put(40, "H", *self.shown)
        self.spoil(image)
        image.words[400:448] = image.words[100:148]
        image.put(400, "H", self.latched_sequence)
        image.put(447, "H", self.latched_sequence)
        return image.words[address : address + quantity]

    def write(self, address: int, value: int) -> None:
        assert address == 1000
        if self.refusing:
            raise RefusedError("writing", 2)
        self.written.append(value)
        if value == 0:
            self.armed, self.state = True, [0, 0, 0, 0]
        elif self.armed:
            self.armed, self.state = False, [self.rival_word or value, *self.outcome, LATCHED_SEQUENCE]
