"""Numbers from 16-bit register words, in the two word orders of the map."""

import struct
from collections.abc import Sequence
from enum import Enum


class WordOrder(Enum):
    """How a value of several registers is laid out; the bytes of one register are always big-endian."""

    ABCD = "abcd"  # most significant word first: addresses 0 to 999
    CDAB = "cdab"  # least significant word first: addresses 2000 to 2999


def unsigned(words: Sequence[int], order: WordOrder = WordOrder.ABCD) -> int:
    """The words as one unsigned integer of 16 bits each."""
    value = 0
    for word in words if order is WordOrder.ABCD else reversed(words):
        value = (value << 16) | word
    return value


def signed(words: Sequence[int], order: WordOrder = WordOrder.ABCD) -> int:
    """The words as one integer in two's complement."""
    bits = 16 * len(words)
    value = unsigned(words, order)
    return value - (1 << bits) if value >> (bits - 1) else value


def float32(words: Sequence[int], order: WordOrder = WordOrder.ABCD) -> float:
    """Two words as an IEEE 754 single; NaN is a value here and means "not valid" in the map."""
    value: float = struct.unpack(">f", unsigned(words, order).to_bytes(4, "big"))[0]
    return value
