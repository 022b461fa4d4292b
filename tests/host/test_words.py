"""Numbers from words, held against pymodbus, which packs and unpacks on its own."""

from typing import Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pymodbus.client import ModbusTcpClient

from host_tool.contract.words import WordOrder, float32, signed, unsigned

TYPES = ModbusTcpClient.DATATYPE


def packed(value: float, kind: ModbusTcpClient.DATATYPE, order: WordOrder) -> list[int]:
    word_order: Literal["big", "little"] = "big" if order is WordOrder.ABCD else "little"
    return ModbusTcpClient.convert_to_registers(value, kind, word_order=word_order)


@given(st.integers(0, 2**32 - 1), st.sampled_from(WordOrder))
def test_an_unsigned_value_survives_in_both_word_orders(value: int, order: WordOrder) -> None:
    assert unsigned(packed(value, TYPES.UINT32, order), order) == value


@given(st.integers(0, 2**64 - 1), st.sampled_from(WordOrder))
def test_a_time_of_64_bits_survives_in_both_word_orders(value: int, order: WordOrder) -> None:
    assert unsigned(packed(value, TYPES.UINT64, order), order) == value


@given(st.integers(-(2**31), 2**31 - 1), st.sampled_from(WordOrder))
def test_a_signed_value_survives_in_both_word_orders(value: int, order: WordOrder) -> None:
    assert signed(packed(value, TYPES.INT32, order), order) == value


@given(st.integers(-(2**15), 2**15 - 1))
def test_a_signed_single_register_has_no_word_order(value: int) -> None:
    words = packed(value, TYPES.INT16, WordOrder.ABCD)
    assert signed(words, WordOrder.ABCD) == signed(words, WordOrder.CDAB) == value


@given(st.floats(width=32, allow_nan=False), st.sampled_from(WordOrder))
def test_a_float_survives_in_both_word_orders(value: float, order: WordOrder) -> None:
    assert float32(packed(value, TYPES.FLOAT32, order), order) == value


@pytest.mark.parametrize(("words", "order"), [((0x0102, 0x0304), WordOrder.ABCD), ((0x0304, 0x0102), WordOrder.CDAB)])
def test_the_published_test_pattern_reads_as_published(words: tuple[int, int], order: WordOrder) -> None:
    assert unsigned(words, order) == 0x01020304
