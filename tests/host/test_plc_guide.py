"""The PLC guide: its commands run, its programs are of their language, its addresses and masks are those of the map."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from blark import parse
from blark import transform as tree
from host.fake_unit import FakeUnit, fake_unit
from host.register_image import measuring_image
from structured_text.plc import shipped_program
from structured_text.program import nodes_of
from structured_text.urscript import python_from

from host_tool.cli.main import run
from host_tool.contract.register_map import WORDS_OF, Register, register_map

GUIDE = (Path(__file__).parents[2] / "docs/guides/plc.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^\$ host-tool (.*)$", GUIDE, re.M)
PROGRAMS = re.findall(r"^```iecst\n(.*?)^```", GUIDE, re.M | re.S)
ROWS = re.findall(r"^\| (\d+)(?:-(\d+)|, (\d+))? \| ([uif]\d\d)(?: x (\d))? \|", GUIDE, re.M)
# What the vendors' manuals declare: TF6250, ModbusFB 4, MB_CLIENT of S7-1200/1500.
VENDORS = {
    "FB_MBReadRegs": "sIPAddr nTCPPort nUnitID nQuantity nMBAddr cbLength pDestAddr bExecute tTimeout"
    " bBusy bError nErrId",
    "FB_MBWriteSingleReg": "sIPAddr nTCPPort nUnitID nMBAddr nValue bExecute tTimeout bBusy bError nErrId",
    "ClientTCP": "xConnect xConnected xError aIPaddr uiPort tConnnectTimeOut",
    "ClientRequestReadHoldingRegisters": "xExecute udiTimeOut xDone xBusy xError rClient uiUnitId udiReplyTimeout"
    " uiMaxRetries uiStartItem uiQuantity pData",
    "ClientRequestWriteSingleRegister": "xExecute udiTimeOut xDone xBusy xError rClient uiUnitId udiReplyTimeout"
    " uiMaxRetries uiItem uiValue",
    "MB_CLIENT": "REQ DISCONNECT MB_MODE MB_DATA_ADDR MB_DATA_LEN MB_DATA_PTR CONNECT DONE BUSY ERROR STATUS",
}
BODY_TYPES = {"unit": "TripointUnit", "client": "MB_CLIENT"}  # where the guide shows a body alone


@pytest.fixture
def unit() -> Iterator[FakeUnit]:
    with fake_unit(measuring_image) as fake:
        yield fake


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_guide_runs_and_prints_what_it_shows(
    command: str, unit: FakeUnit, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    words = [unit.device if word == "192.168.1.20:502" else word for word in command.split()]
    if "--out" in words:
        words[words.index("--out") + 1] = str(tmp_path / "out")
    assert run(words) == (1 if "probe" in words else 0)
    shown = GUIDE.split(f"$ host-tool {command}\n")[1].split("```")[0]
    if not shown.startswith("$"):
        assert capsys.readouterr().out == shown


def test_the_guide_shows_every_format() -> None:
    assert len(COMMANDS) == 7


def members_of(type_name: str) -> set[str]:
    if type_name in VENDORS:
        return set(VENDORS[type_name].split())
    return {one.name for one in shipped_program().units[type_name.lower()].declarations}


def parsed(program: str) -> Any:
    whole = program if program.startswith("PROGRAM") else f"PROGRAM Part\n{program}END_PROGRAM\n"
    result = parse.parse_source_code(whole)
    assert result.exception is None, result.exception
    (item,) = result.transform().items
    return item


def types_in(item: Any) -> dict[str, str]:
    """The types of the instances that a program declares, or that the guide names for a body."""
    found = dict(BODY_TYPES)
    for section in item.declarations:
        for one in section.items:
            spec = str(getattr(one.init, "spec", getattr(one.init, "name", one.init)))
            name = re.sub(r"[ (].*", "", spec, flags=re.S).rpartition(".")[2]
            found |= {str(variable.variable.name): name for variable in one.variables}
    return found


@pytest.mark.parametrize("program", PROGRAMS, ids=[f"program {i}" for i in range(len(PROGRAMS))])
def test_a_program_of_the_guide_is_structured_text_and_names_what_exists(program: str) -> None:
    item = parsed(program)
    types = types_in(item)
    checked = 0
    for node in nodes_of(item):
        if isinstance(node, tree.FunctionCallStatement):
            given = {str(one.name) for one in node.parameters}
            assert given <= members_of(types[str(node.name)]), str(node.name)
            checked += 1
        if isinstance(node, tree.MultiElementVariable) and str(node.name) in types:
            holder = types[str(node.name)]
            for element in node.elements:
                if isinstance(element, tree.FieldSelector) and (holder in VENDORS or holder.startswith("Tripoint")):
                    assert str(element.field) in members_of(holder), f"{node}"
                    holder = "TripointVerdict" if str(element.field) in ("live", "latched") else ""
                    checked += 1
    assert checked > 0 or "Tripoint_measured" in program


def test_the_tags_of_the_logix_program_are_those_of_the_export(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["plc", "export", "--format", "rockwell", "--request", "identity", "--request", "pose"]) == 0
    exported = set(re.findall(r"^(?:ALIAS|TAG),,(\w+),", capsys.readouterr().out, re.M))
    named = set(re.findall(r"\bTripoint_\w+", GUIDE))
    assert len(named) >= 8
    assert named <= exported


def test_the_urscript_of_the_guide_is_urscript() -> None:
    (script,) = re.findall(r"^```urscript\n(.*?)^```", GUIDE, re.M | re.S)
    calls: list[tuple[Any, ...]] = []
    names: dict[str, Any] = {
        "tripoint_connect": lambda *given: calls.append(given),
        "tripoint_latch": lambda *given: [0.0, *given, 0.0, 0.0],
    }
    exec(python_from(script.replace("p[", "[")), names)
    assert calls == [("192.168.1.20",)]
    assert names["target_in_unit"][:4] == [43981, 2000, 500, False]


def register_at(address: int) -> Register:
    (found,) = (
        one
        for name in ("state", "measured")
        for one in register_map().blocks[name].registers.values()
        if one.address == address
    )
    return found


@pytest.mark.parametrize("row", ROWS, ids=[row[0] for row in ROWS])
def test_an_address_of_the_guide_is_that_of_the_map(row: tuple[str, str, str, str, str]) -> None:
    first, last, other, kind, times = row
    places = [int(first)] + ([int(other)] if other else [])
    if last:
        places = [int(first) + i * WORDS_OF[kind] for i in range(int(times or 1))]
        assert places[-1] + WORDS_OF[kind] - 1 == int(last)
    assert {register_at(place).type for place in places} == {kind}


def test_the_masks_of_the_guide_are_the_status_bits_they_stand_for() -> None:
    bit = {one.name: 1 << one.number for one in register_map().bits["status"]}
    pose, refused = bit["position_valid"] | bit["orientation_valid"], bit["stale"] | bit["simulated"]
    checked = bit["verified"] | bit["mount_watched"]
    for mask, value in (
        (pose | refused, pose),
        (bit["position_valid"] | refused, bit["position_valid"]),
        (pose | refused | checked, pose | checked),
    ):
        assert f"(101 AND 16#{mask:04X}) = 16#{value:04X}" in GUIDE
    assert f"mask with `16#{pose | bit['stale']:04X}` there" in GUIDE


def test_the_reasons_of_the_guide_are_those_of_the_block() -> None:
    block = shipped_program().units["tripointblock"]
    reasons = {str(one.init.value) for one in block.declarations if one.name.startswith("REASON_")}
    table = GUIDE.split("| reason | what | look at |")[1].split("\n\n")[0]
    assert reasons == {"0", *re.findall(r"^\| (\d+) \|", table, re.M)}
