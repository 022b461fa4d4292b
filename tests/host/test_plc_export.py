"""The files for PLC tools: laid over the answer as each tool's memory is, every member is what host-tool reads."""

from __future__ import annotations

import csv
import json
import re
import struct
from pathlib import Path
from typing import Any

import pytest
from blark import parse
from host.register_image import Image
from structured_text.fake_wire import full_image

from host_tool.cli.main import run
from host_tool.contract.decode import BlockWords
from host_tool.contract.register_map import register_map
from host_tool.errors import ExitCode
from host_tool.plc.formats import FORMATS, text_of
from host_tool.plc.requests import BLOCKS_OF, MAX_WORDS, requests

Capture = pytest.CaptureFixture[str]
LETTERS = {"WORD": "H", "UINT": "H", "INT": "h", "UDINT": "I", "DINT": "i", "REAL": "f", "ULINT": "Q", "LINT": "q"}
MEMBER = re.compile(r"^ +(\w+) : (?:ARRAY\[0\.\.(\d+)\] OF )?(\w+);", re.M | re.I)


def read_by_host_tool(image: Image, block: str, name: str) -> float:
    of = register_map().blocks[block]
    return BlockWords(of, image.words[of.first : of.last + 1]).raw(name)


def laid_over(text: str, memory: bytes, order: str) -> dict[str, float]:
    """The members of one structure, read from memory without padding."""
    values, at = {}, 0
    for name, last, kind in MEMBER.findall(text):
        letter = LETTERS[kind.upper()]
        if not last:
            (values[name],) = struct.unpack_from(order + letter, memory, at)
        at += struct.calcsize(order + letter) * (int(last) + 1 if last else 1)
    assert at == len(memory)
    return values


def expected(image: Image, request: str) -> dict[str, float]:
    return {
        f"{block}_{name}": read_by_host_tool(image, block, name)
        for block in BLOCKS_OF[request]
        for name in register_map().blocks[block].registers
    }


@pytest.mark.parametrize("request_name", BLOCKS_OF)
@pytest.mark.parametrize("form", ["beckhoff", "codesys"])
def test_little_endian_memory_filled_from_2000_holds_every_value(form: str, request_name: str) -> None:
    image = full_image()
    (request,) = requests((request_name,))
    words = image.mirrored()[request.first : request.first + request.count]
    memory = struct.pack(f"<{len(words)}H", *words)  # as the client stores them
    text = text_of(FORMATS[form], (request_name,), "")
    assert f" {2000 + request.first}, " in text
    assert laid_over(text, memory, "<") == pytest.approx(expected(image, request_name), nan_ok=True)


@pytest.mark.parametrize("request_name", BLOCKS_OF)
def test_big_endian_memory_filled_from_0_holds_every_value(request_name: str) -> None:
    image = full_image()
    (request,) = requests((request_name,))
    memory = struct.pack(f">{request.count}H", *image.words[request.first : request.first + request.count])
    text = text_of(FORMATS["siemens"], (request_name,), "")
    assert f"MB_DATA_ADDR {request.first}, MB_DATA_LEN {request.count}" in text
    found = laid_over(text, memory, ">")
    for name in [name for name in found if name.endswith("_high")]:
        whole = name.removesuffix("_high")
        found[whole] = found.pop(name) * (1 << 32) + found.pop(f"{whole}_low")
    assert found == pytest.approx(expected(image, request_name), nan_ok=True)


def test_rockwell_tags_copy_or_alias_every_value() -> None:
    image = full_image()
    text = text_of(FORMATS["rockwell"], ("pose",), "")
    lines = text.splitlines()
    rows = list(csv.reader(lines[lines.index("0.3") + 1 :]))
    assert {len(row) for row in rows} == {len(rows[0])}
    words = image.mirrored()[32:148]
    memory = struct.pack(f"<{len(words)}H", *words)
    found: dict[str, Any] = {}
    for kind, _, name, description, data_type, specifier in rows[2:]:
        source = specifier if kind == "ALIAS" else description
        match = re.search(r"TripointPose\[(\d+)\]", source)
        assert match is not None
        letter = "h" if kind == "ALIAS" else LETTERS[data_type]
        (found[name.removeprefix("Tripoint_")],) = struct.unpack_from(f"<{letter}", memory, 2 * int(match.group(1)))
    wanted = expected(image, "pose")
    assert found.keys() == wanted.keys()
    for name, value in found.items():
        assert wanted[name] - value in (0, 1 << 16, 1 << 32), name  # what is unsigned may read as negative here


def test_a_rockwell_tag_whose_unknown_reads_negative_says_so() -> None:
    lines = text_of(FORMATS["rockwell"], (), "").splitlines()
    uncertain = [line for line in lines if "_uncertainty_" in line and ("DINT" in line or "ALIAS" in line)]
    assert len(uncertain) == 2 * 6 + 2 * 3 + 12  # integer blocks, 16-bit blocks, points (whose names end in a number)
    assert all("never a small number" in line for line in uncertain)


def test_every_tag_has_one_name_that_all_tools_take() -> None:
    names = [tag.name for request in requests() for tag in request.tags]
    assert len(names) == len(set(names))
    assert max(len(f"Tripoint_{name}") for name in names) <= 40  # Rockwell's limit
    for one in FORMATS.values():
        text = text_of(one, (), "192.168.1.20")
        assert text.isascii()
        assert all(line.count('"') % 2 == 0 for line in text.splitlines())


def test_every_request_is_one_that_modbus_allows_and_they_cover_the_map() -> None:
    assert max(request.count for request in requests()) <= MAX_WORDS
    covered = {block for request in BLOCKS_OF.values() for block in request}
    assert covered == set(register_map().blocks) - {"command"}


@pytest.mark.parametrize("form", ["beckhoff", "codesys"])
def test_the_structures_are_structured_text(form: str) -> None:
    parsed = parse.parse_source_code(text_of(FORMATS[form], ("pose", "latched_single"), ""))
    assert parsed.exception is None
    assert [type(item).__name__ for item in parsed.transform().items] == ["DataTypeDeclaration"] * 2


def test_the_listing_gives_each_way_of_counting(capsys: Capture) -> None:
    assert run(["plc", "export", "--format", "csv"]) == ExitCode.PASS
    rows = {row["name"]: row for row in csv.DictReader(capsys.readouterr().out.splitlines())}
    x = rows["measured_x"]
    places = ("address", "address_least_word_first", "address_from_1", "input_register", "holding_register")
    assert [x[place] for place in places] == ["110", "2110", "111", "30111", "40111"]
    assert (x["type"], x["registers"], x["unit"], x["scale"], x["unknown"]) == ("i32", "2", "mm", "0.001", "0x80000000")
    assert rows["command_word"]["address"] == "1000"
    assert rows["command_word"]["address_least_word_first"] == ""


def test_a_robots_signals_are_read_on_demand_and_name_the_unit(capsys: Capture) -> None:
    assert run(["plc", "export", "--format", "ur", "--device", "192.168.1.20:502"]) == ExitCode.PASS
    lines = capsys.readouterr().out.splitlines()
    signals = [re.findall(r'[^(),"\s]+', line)[1:] for line in lines if line.startswith("modbus_add_signal")]
    assert {(ip, unit) for ip, unit, *_ in signals} == {("192.168.1.20", "255")}
    by_name = {name: (int(address), kind) for _, _, address, kind, name in signals}
    assert by_name["tp_command_word"] == (1000, "3")
    assert by_name["tp_latched_single_x"] == (452, "2")
    assert sum(line.startswith("modbus_set_signal_update_frequency") for line in lines) == len(signals)


def test_without_a_format_the_formats_are_listed(capsys: Capture) -> None:
    assert run(["plc", "export"]) == ExitCode.PASS
    out = capsys.readouterr().out
    assert all(f"{one.name} " in out for one in FORMATS.values())
    assert run(["plc", "export", "--json"]) == ExitCode.PASS
    record = json.loads(capsys.readouterr().out)
    assert list(record["formats"]) == list(FORMATS)
    assert record["requests"] == list(BLOCKS_OF)


def test_a_file_is_written_whole_or_the_reason_said(capsys: Capture, tmp_path: Path) -> None:
    file = tmp_path / "Tripoint.scl"
    assert run(["plc", "export", "--format", "siemens", "--out", str(file), "--json"]) == ExitCode.PASS
    assert json.loads(capsys.readouterr().out)["lines"] == len(file.read_text(encoding="utf-8").splitlines())
    assert run(["plc", "export", "--format", "siemens", "--out", str(tmp_path / "none" / "file")]) == ExitCode.USAGE
    assert capsys.readouterr().err.startswith("E-PLC-03 cannot write")
