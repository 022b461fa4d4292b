"""A register image written from the published map, address by address: the outside truth of the decoder's tests."""

import struct
from dataclasses import dataclass, field

IMAGE_LENGTH = 1000
MIRROR_AT = 2000
UTC_NS = 1_795_000_000_123_456_789


def _words(packed: bytes) -> list[int]:
    return list(struct.unpack(f">{len(packed) // 2}H", packed))


@dataclass
class Image:
    """Words 0 to 999, and the places of the wide values, which the mirror needs to turn them around."""

    words: list[int] = field(default_factory=lambda: [0] * IMAGE_LENGTH)
    wide: dict[int, int] = field(default_factory=dict)

    def put(self, address: int, kind: str, *values: float) -> None:
        """Writes consecutive values; `kind` is a struct letter: H h I i Q f."""
        for value in values:
            words = _words(struct.pack(f">{kind}", value))
            self.words[address : address + len(words)] = words
            if len(words) > 1:
                self.wide[address] = len(words)
            address += len(words)

    def mirrored(self) -> list[int]:
        """The same image, least significant word first."""
        words = list(self.words)
        for address, count in self.wide.items():
            words[address : address + count] = reversed(words[address : address + count])
        return words


def measuring_image(sequence: int = 70000, status: int = 0x0647) -> Image:
    """A simulated unit that measures (-12.345, 6.789, 400.001) mm; a position without orientation."""
    image = Image()
    image.put(0, "H", 0x5450, 1, 1, IMAGE_LENGTH)
    image.put(4, "I", 0x01020304)
    image.put(6, "f", 123456.0)
    image.put(8, "I", 4711)
    image.put(10, "H", 0, 2, 9, 1)
    image.put(14, "I", 0xCAFE0001, 0xBEEF0002)
    image.put(32, "H", 99, status, 0, 1 << 9, 1, 3)
    image.put(38, "I", 3600)
    _put_pose(image, sequence, status)
    _put_points(image, sequence)
    _put_health(image)
    return image


def _put_pose(image: Image, sequence: int, status: int) -> None:
    image.put(100, "H", sequence & 0xFFFF, status, 0, 1 << 9)
    image.put(104, "Q", UTC_NS)
    image.put(108, "I", 23456)
    image.put(110, "i", -12345, 6789, 400001)
    image.put(116, "i", *[-(1 << 31)] * 7)
    image.put(130, "I", 120000, 110000, 350500)
    image.put(136, "I", *[0xFFFFFFFF] * 3)
    image.put(142, "H", 51, 1)
    image.put(144, "I", sequence)
    image.put(146, "H", 0xABCD, sequence & 0xFFFF)
    nan = float("nan")
    image.put(200, "H", sequence & 0xFFFF, status, 0, 1 << 9)
    image.put(204, "Q", UTC_NS)
    image.put(208, "f", 23.456, -12.345, 6.789, 400.001, *[nan] * 7, 0.12, 0.11, 0.3505, nan, nan, nan, 0.051)
    image.put(244, "I", sequence)
    image.put(246, "H", 0xABCD, sequence & 0xFFFF)


def _put_points(image: Image, sequence: int) -> None:
    image.put(500, "H", sequence & 0xFFFF, 1)
    image.put(502, "i", -12345, 6789, 400001)
    image.put(508, "H", 1, 351, 51, 0b10)
    image.put(622, "H", sequence & 0xFFFF)


def _put_health(image: Image) -> None:
    for start, temperature in ((700, 0x8000), (716, 415)):
        image.put(start, "H", 2, 2997)
        image.put(start + 2, "I", 1000)
        image.put(start + 4, "H", 0xFFFF, temperature)
        image.put(start + 6, "I", 7)
        image.put(start + 8, "H", 1, 201, 14, 350, 2, 210, 1180)
    image.put(732, "i", -1500)
    image.put(734, "I", 200, 375, 350, 980)
    image.put(742, "H", 42)
    image.put(743, "h", -5)
    image.put(744, "H", 0xFFFF, 523, 61)
