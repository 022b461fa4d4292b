"""The register map is checked, and the check refuses planted violations."""

from __future__ import annotations

import shutil
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import check_registers
import pytest
from register_map.check import problems
from register_map.header import header
from register_map.model import MapError, from_document, load
from register_map.page import page
from register_map.structured_text import SECTIONS, with_constants

Document = dict[str, Any]


def document() -> Document:
    """The map of the tree, parsed anew for each test to spoil."""
    return tomllib.loads(check_registers.MAP.read_text(encoding="utf-8"))


def block(spoilt: Document, name: str) -> Document:
    """A block of the map, to be spoilt."""
    return next(table for table in spoilt["blocks"] if table["name"] == name)


def register(spoilt: Document, block_name: str, name: str) -> Document:
    """A register of the map, to be spoilt."""
    return next(row for row in block(spoilt, block_name)["registers"] if row["name"] == name)


def test_the_map_of_the_tree_is_sound_and_its_page_up_to_date() -> None:
    assert check_registers.verdict(check_registers.MAP, check_registers.PAGE) == []


@pytest.mark.parametrize(
    ("spoil", "complaint"),
    [
        (lambda d: register(d, "measured", "y").update(address=111), "register 111 belongs to measured.x and to"),
        (lambda d: register(d, "measured", "x").update(type="u64"), "register 112 belongs to measured.x and to"),
        (lambda d: register(d, "state", "command_detail").update(address=64), "does not lie inside its block"),
        (lambda d: register(d, "timing", "load").update(address=747, type="u32"), "does not lie inside its block"),
        (lambda d: block(d, "timing").update(last=1001), "outside the image"),
        (lambda d: block(d, "latched").update(last=446), "is like measured but not as long"),
        (lambda d: register(d, "single", "sequence_end").update(address=314), "its sequence first and last"),
        (lambda d: register(d, "state", "status").update(bits="nothing"), "there are no bits"),
        (lambda d: register(d, "identity", "mode").update(choices="nothing"), "there are no choices"),
        (lambda d: register(d, "single", "x").update(unknown=0x80000000), "is not a raw number of i16"),
        (lambda d: register(d, "measured_float", "x").update(unknown=0), 'unknown of a f32 is "nan"'),
        (lambda d: register(d, "measured", "x").update(scale=0), "scale must be greater than 0"),
        (lambda d: register(d, "measured", "x").update(meaning=""), "must say something"),
        (lambda d: register(d, "measured", "x").update(name="X position"), "is not snake_case"),
        (lambda d: register(d, "points", "x").update(stride=1), "repeated every 1 registers but 2 long"),
        (lambda d: register(d, "measured", "y").update(name="x"), "'x' exists twice"),
        (lambda d: d.update(minor=7), "map_minor: reads 2, but the map says 7"),
        (lambda d: register(d, "identity", "map_major").update(constant=2), "map_major: reads 2, but the map says 1"),
        (lambda d: d["server"].update(idle_ms=0), "idle_ms must be a whole number greater than 0"),
        (lambda d: d["bits"][0]["bits"][3].update(bit=16), "outside 0 to 15"),
        (lambda d: d["bits"][0]["bits"][3].update(bit=2), "number in bits status '2' exists twice"),
    ],
)
def test_a_planted_violation_is_refused(spoil: Callable[[Document], None], complaint: str) -> None:
    spoilt = document()
    spoil(spoilt)
    assert any(complaint in problem for problem in problems(from_document(spoilt)))


@pytest.mark.parametrize(
    ("spoil", "complaint"),
    [
        (lambda d: d.update(format="tripoint-registers/2"), "format must be"),
        (lambda d: d.pop("mirror_at"), "'mirror_at' is missing"),
        (lambda d: d["server"].update(ilde_ms=1), "ilde_ms"),
        (lambda d: register(d, "measured", "x").update(type="i24"), "'i24' of 'x' is none of"),
        (lambda d: register(d, "measured", "x").update(sclae=2), "sclae"),
        (lambda d: register(d, "measured", "x").pop("since"), "since"),
        (lambda d: block(d, "latched").update(like="nothing"), "does not come before it"),
    ],
)
def test_a_file_that_is_not_a_map_is_refused(spoil: Callable[[Document], None], complaint: str) -> None:
    spoilt = document()
    spoil(spoilt)
    with pytest.raises(MapError, match=complaint):
        from_document(spoilt)


def test_a_page_that_is_not_up_to_date_is_refused(tmp_path: Any) -> None:
    old = tmp_path / "registers.md"
    old.write_text(
        check_registers.PAGE.read_text(encoding="utf-8").replace("heartbeat", "heart beat"), encoding="utf-8"
    )
    assert "run `make docs`" in check_registers.verdict(check_registers.MAP, old)[0]


def test_the_check_fails_on_an_old_page_and_passes_the_tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    old = tmp_path / "registers.md"
    old.write_text("# Registers\n", encoding="utf-8")
    named = [check_registers.MAP, old, check_registers.PLC]
    monkeypatch.setattr(sys, "argv", ["check_registers.py", *(str(path) for path in named)])
    assert check_registers.main() == 1
    monkeypatch.setattr(sys, "argv", ["check_registers.py"])
    assert check_registers.main() == 0


def test_a_missing_page_is_refused(tmp_path: Any) -> None:
    assert check_registers.verdict(check_registers.MAP, tmp_path / "registers.md") != []


def test_the_constants_for_plcs_are_those_of_the_map() -> None:
    assert check_registers.plc_verdict(check_registers.MAP, check_registers.PLC) == []


def test_a_constant_that_was_changed_by_hand_is_refused(tmp_path: Path) -> None:
    shutil.copytree(check_registers.PLC, tmp_path / "plc")
    file = tmp_path / "plc/TripointBlock.st"
    file.write_text(file.read_text(encoding="utf-8").replace("X : INT := 10;", "X : INT := 12;"), encoding="utf-8")
    assert "TripointBlock.st is not what" in check_registers.plc_verdict(check_registers.MAP, tmp_path / "plc")[0]
    assert with_constants(file.name, file.read_text(encoding="utf-8"), load(check_registers.MAP)) == (
        check_registers.PLC / file.name
    ).read_text(encoding="utf-8")


def test_a_file_for_plcs_without_its_constants_is_refused(tmp_path: Path) -> None:
    shutil.copytree(check_registers.PLC, tmp_path / "plc")
    (tmp_path / "plc/TripointState.st").write_text("FUNCTION_BLOCK TripointState\n", encoding="utf-8")
    assert "has 0 sections" in check_registers.plc_verdict(check_registers.MAP, tmp_path / "plc")[0]
    (tmp_path / "plc/TripointState.st").unlink()
    assert "No such file" in check_registers.plc_verdict(check_registers.MAP, tmp_path / "plc")[0]


def test_every_constant_follows_the_map() -> None:
    spoilt = document()
    register(spoilt, "measured", "x").update(scale=0.002)
    for row in (row for row in spoilt["bits"][0]["bits"] if row["name"] in ("stale", "degraded")):
        row["bit"] = 9 - row["bit"]
    changed = from_document(spoilt)
    texts = {name: (check_registers.PLC / name).read_text(encoding="utf-8") for name in SECTIONS}
    block = with_constants("TripointBlock.st", texts["TripointBlock.st"], changed)
    assert "POSITION_MM : LREAL := 0.002;" in block
    assert "STALE : WORD := 16#0020;" in block


# The design's own words, so that a changed map is noticed: address, type, name.
ANCHORS = [
    (0, "u16", "identity.magic"), (4, "u32", "identity.word_order_integer"), (6, "f32", "identity.word_order_float"),
    (13, "u16", "identity.mode"), (14, "u32", "identity.calibration_id"), (18, "u16", "identity.output_frame"),
    (32, "u16", "state.heartbeat"), (36, "u16", "state.state"), (38, "u32", "state.uptime"),
    (40, "u16", "state.command_echo"), (104, "u64", "measured.time"), (108, "u32", "measured.age"),
    (110, "i32", "measured.x"), (116, "i32", "measured.a"), (122, "i32", "measured.qw"),
    (130, "u32", "measured.uncertainty_x"), (142, "u16", "measured.residual"), (144, "u32", "measured.sequence_long"),
    (146, "u16", "measured.setup"), (208, "f32", "measured_float.age"), (240, "f32", "measured_float.uncertainty_c"),
    (258, "f32", "predicted.extrapolated"), (297, "u16", "predicted.sequence_end"), (304, "i16", "single.x"),
    (313, "u16", "single.age"), (408, "u32", "latched.age"), (452, "i16", "latched_single.x"),
    (463, "u16", "latched_single.sequence_end"), (501, "u16", "points.count"), (502, "i32", "points.x"),
    (622, "u16", "points.sequence_end"), (705, "i16", "left_camera.temperature"),
    (714, "u16", "left_camera.below_clipping"),
    (722, "u32", "right_camera.dropped"), (729, "u16", "right_camera.above_dim"),
    (732, "i32", "timing.skew"), (743, "i16", "timing.side_length_error"), (746, "u16", "timing.load"),
    (1000, "u16", "command.word"),
]  # fmt: skip


def test_registers_stand_where_the_contract_puts_them() -> None:
    table = {
        f"{block.name}.{register.name}": (register.address, register.type)
        for block in load(check_registers.MAP).blocks
        for register in block.registers
    }
    assert {name: table.get(name) for _, _, name in ANCHORS} == {name: (at, kind) for at, kind, name in ANCHORS}


def test_the_page_gives_a_clients_limits_as_the_server_holds_them() -> None:
    spoilt = document()
    spoilt["server"]["idle_ms"] = 12_345
    changed = from_document(spoilt)
    assert "| without any request | 12345 ms | closed |" in page(changed)
    assert "kIdleMs = 12345;" in header(changed)


def test_the_header_names_each_bit_as_the_map_does() -> None:
    register_map = load(check_registers.MAP)
    for name, rows in register_map.bits.items():
        assert f"k{name.capitalize()}Bits" in header(register_map)
        for row in rows:
            assert f'{{{row.value}, "{row.name}"}},' in header(register_map)


def test_every_register_has_its_row_on_the_page_and_its_field_in_the_header() -> None:
    register_map = load(check_registers.MAP)
    reference, code = page(register_map), header(register_map)
    for one in register_map.blocks:
        assert f"namespace {one.name} {{" in code
        for field in one.registers:
            assert f"`{one.name}.{field.name}`" in reference
            assert f'"{one.name}.{field.name}' in code or one.name == "command"
