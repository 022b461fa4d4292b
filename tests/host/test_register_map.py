"""The map as data: whole, without overlaps, and the same file that the unit is built from."""

from pathlib import Path

import pytest

from host_tool.contract.conditions import REMEDIES, Status
from host_tool.contract.register_map import RegisterMap, map_from, register_map

REPOSITORY = Path(__file__).parents[2]
SOURCE = REPOSITORY / "firmware/contract/registers.toml"


def places(a_map: RegisterMap) -> list[tuple[int, str]]:
    """Every single register with the value that lives there."""
    return [
        (register.address + word, f"{block.name}.{register.name}")
        for block in a_map.blocks.values()
        for register in block.registers.values()
        for word in range(register.count)
    ]


def test_the_packaged_map_is_the_one_the_unit_is_built_from() -> None:
    packaged = REPOSITORY / "host/src/host_tool/contract/registers.toml"
    assert packaged.resolve() == SOURCE.resolve()


def test_no_two_values_share_a_register() -> None:
    taken = [address for address, _ in places(register_map())]
    assert len(taken) == len(set(taken))


def test_every_register_lies_inside_its_block() -> None:
    for block in register_map().blocks.values():
        for register in block.registers.values():
            assert block.first <= register.address <= register.address + register.count - 1 <= block.last


@pytest.mark.parametrize(
    ("block", "name", "address"),
    [
        ("identity", "word_order_float", 6),
        ("measured", "sequence_end", 147),
        ("predicted", "extrapolated", 258),
        ("predicted", "sequence_end", 297),
        ("latched", "age", 408),
        ("latched_single", "age", 461),
        ("points", "flags_12", 621),
        ("right_camera", "frames_per_second", 717),
        ("timing", "latency_p99", 740),
    ],
)
def test_moved_and_repeated_registers_are_where_the_published_map_has_them(block: str, name: str, address: int) -> None:
    assert register_map().blocks[block].registers[name].address == address


def test_status_bits_have_the_names_of_the_map() -> None:
    assert {member.bit_length() - 1: (member.name or "").lower() for member in Status} == {
        meaning.number: meaning.name for meaning in register_map().bits["status"]
    }


def test_every_fault_and_warning_has_a_remedy_and_no_remedy_is_left_over() -> None:
    named = {meaning.name for group in ("fault", "warning") for meaning in register_map().bits[group]}
    assert named == set(REMEDIES)


def test_a_bit_of_a_newer_unit_is_shown() -> None:
    assert [meaning.name for meaning in register_map().bits_set("fault", 1 << 15)] == ["bit_15"]


def test_a_number_of_a_newer_unit_is_shown() -> None:
    assert register_map().choice("state", 77) == "unknown (77)"


def test_another_file_format_is_refused() -> None:
    with pytest.raises(ValueError, match="tripoint-registers/2"):
        map_from({"format": "tripoint-registers/2"})


def test_a_key_that_the_reader_does_not_know_is_refused() -> None:
    register = {"address": 0, "name": "a", "type": "u16", "meaning": "m", "since": "1.0", "colour": "red"}
    block = {"name": "b", "first": 0, "last": 0, "registers": [register]}
    with pytest.raises(TypeError, match="colour"):
        map_from({"format": "tripoint-registers/1", "blocks": [block]})
