"""Structured Text is refused where compilers refuse it or differ, and the files of deploy/plc keep to what is left."""

from __future__ import annotations

from pathlib import Path

import pytest
from blark import transform as tree
from structured_text.execution import Runtime
from structured_text.plc import BUFFER, shipped_program
from structured_text.program import CONSTANTS, Program, nodes_of, program_from
from structured_text.timer import Clock, Timer
from structured_text.values import StructuredTextError, Value

# Words that IEC 61131-3, TwinCAT, CODESYS, Siemens SCL or Rockwell's Structured Text keep for themselves.
KEPT = """
    abs acos action and any array asin at atan begin block bool by byte call case class concat configuration
    constant continue cos count date delete dint div do dt dword else elsif end exit exp extends false finally find
    for from function goto if implements in initial_step input insert int interface internal interval jmp label left
    len lint ln log lreal ltime lword max method mid min mod mux name namespace not null of on or output override
    pointer priority private program property protected public r read_only read_write real reference region repeat
    replace resource ret retain return right rol ror sel shl shr sin single sint sizeof sqrt step string struct
    super tan task then this time timer to tod tof ton tp transition true trunc type udint uint ulint union until
    usint var version wchar while with word write_var wstring xor
    """
LONGEST_NAME = 40  # Rockwell's limit
SHELL = """\
FUNCTION_BLOCK Block
VAR
    i : INT;
    u : UINT;
    w : WORD;
    r : LREAL;
    b : BOOL;
    {declared}
END_VAR
{body}
END_FUNCTION_BLOCK
"""


def program_of(folder: Path, body: str, declared: str = "") -> Program:
    file = folder / "block.st"
    file.write_text(SHELL.format(body=body, declared=declared), encoding="utf-8")
    return program_from([file])


def run(folder: Path, body: str, declared: str = "") -> Runtime:
    runtime = Runtime(program_of(folder, body, declared))
    runtime.call(runtime.instance("Block"), {})
    return runtime


@pytest.mark.parametrize(
    ("body", "complaint"),
    [
        ("u := i;", "INT where UINT is wanted"),
        ("i := w;", "WORD where INT is wanted"),
        ("r := i;", "INT where LREAL is wanted"),
        ("b := w AND 16#0001;", "WORD where BOOL is wanted"),
        ("w := 1;", "whole literal where WORD is wanted"),
        ("u := 16#0001;", "16# literal where UINT is wanted"),
        ("b := w > 16#0001;", "> between WORD"),
        ("b := r = i;", "INT where LREAL is wanted"),
        ("i := i + 32767 + 1;", "32768 is outside INT"),
        ("u := u - 1;", "-1 is outside UINT"),
        ("i := -1 / 2;", "/ of a negative number"),
        ("u := u / 0;", "division by 0"),
        ("u := WORD_TO_UINT(i);", "INT where WORD is wanted"),
        ("b := missing;", "there is no missing"),
        ("missing := TRUE;", "missing cannot be assigned"),
        ("Limit := 4;", "limit cannot be assigned"),
        ("b := few[4];", "index 4 is outside the array"),
        ("few := more;", "an array of 5 where one of 4 is wanted"),
        ("b := SEL(b);", "there is no function SEL"),
        ("WHILE b DO i := 1; END_WHILE;", "WhileStatement is not used here"),
        ("late(IN := 1);", "whole literal where BOOL is wanted"),
    ],
)
def test_what_compilers_refuse_or_differ_in_is_refused(body: str, complaint: str, tmp_path: Path) -> None:
    declared = (
        "few : ARRAY[0..3] OF BOOL; more : ARRAY[0..4] OF BOOL; late : TON;\nEND_VAR\nVAR CONSTANT\nLimit : INT := 3;"
    )
    with pytest.raises(StructuredTextError, match=complaint):
        run(tmp_path, body, declared)


@pytest.mark.parametrize(
    ("body", "declared", "complaint"),
    [
        ("i := ;", "", "block.st"),
        ("IF b THEN i := 1;", "", "block.st"),
        ("i := 1", "", "block.st"),
        ("i := 1;", "I : BOOL;", "Block.I exists twice"),
    ],
)
def test_what_is_no_structured_text_is_refused(body: str, declared: str, complaint: str, tmp_path: Path) -> None:
    with pytest.raises(StructuredTextError, match=complaint):
        program_of(tmp_path, body, declared)


def test_the_timer_is_the_standards_on_delay_timer() -> None:
    clock, timer = Clock(), Timer()
    timer.members["pt"] = Value("TIME", 50)
    story = [(0, False, 0, False), (10, True, 0, False), (40, True, 30, False), (60, True, 50, True)]
    story += [(90, True, 50, True), (100, False, 0, False), (110, True, 0, False)]
    for now_ms, given, elapsed_ms, reached in story:
        clock.now_ms = now_ms
        timer.members["in"] = Value("BOOL", given)
        timer.run(clock)
        assert (timer.members["et"].data, timer.members["q"].data) == (elapsed_ms, reached)


@pytest.fixture(scope="module")
def shipped() -> Program:
    return shipped_program()


def test_no_shipped_name_is_kept_by_a_compiler_or_too_long(shipped: Program) -> None:
    names = {one.name for unit in shipped.units.values() for one in unit.declarations} | set(shipped.units)
    assert {name for name in names if name.lower() in KEPT.split() or len(name) > LONGEST_NAME or "__" in name} == set()


def test_every_shipped_variable_is_used(shipped: Program) -> None:
    for unit in shipped.units.values():
        if unit.body is None:
            continue
        used = {
            str(node.name).lower()
            for node in nodes_of(unit.body)
            if isinstance(node, (tree.SimpleVariable, tree.EnumeratedValue))
        }
        unused = {one.name for one in unit.declarations if one.name.lower() not in used}
        assert {name for name in unused if not name.startswith(("REASON_", "RESULT_"))} == set(), unit.name


def test_the_buffer_holds_the_longest_answer(shipped: Program) -> None:
    constants = {
        one.name: one.init.value for one in shipped.units["tripointunit"].declarations if one.kind == CONSTANTS
    }
    longest = max(int(str(value)) for name, value in constants.items() if name.endswith("_QUANTITY"))
    assert longest == BUFFER == len(Runtime(shipped).instance("TripointUnit").members["words"].items)
    assert longest <= 125  # of one request, by the Modbus specification
