"""The checks of the code are checked: each must refuse a planted violation and accept the tree as it is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import check_layers
import check_sizes
import outside_headers
import pytest

TOP = Path(__file__).parents[2]
PAGE = (TOP / "ARCHITECTURE.md").read_text(encoding="utf-8")
ROOMS = check_layers.rooms_of(PAGE)


def plant(tree: Path, file: str, text: str) -> Path:
    planted = tree / file
    planted.parent.mkdir(parents=True, exist_ok=True)
    planted.write_text(text)
    return tree


@pytest.mark.parametrize(
    ("file", "include", "why"),
    [
        ("values/time.h", '"geometry/rig.h"', "values knows nobody"),
        ("values/time.h", "<geometry/rig.h>", "angle brackets hide nothing"),
        ("values/time.h", "<line/model.h>", "angle brackets hide nothing"),
        ("geometry/rig.cpp", '"ports/frame.h"', "geometry is pure"),
        ("geometry/rig.hpp", '"ports/frame.h"', "a header by another name is one too"),
        ("geometry/rig.cpp", '"../ports/frame.h"', "no way around"),
        ("geometry/rig.cpp", " PORTS_FRAME", "a macro hides nothing"),
        ("geometry/rig.cpp", "_next <vector>", "only plain includes can be judged"),
        ("line/match/match.cpp", '"line/gate/gate.h"', "a stage knows only the stages before it"),
        ("line/pose/pose.cpp", '"capture/mjpeg_decoder.h"', "a stage does no I/O"),
        ("line/pose/pose.cpp", "<fstream>", "a stage does no I/O"),
        ("line/gate/gate.cpp", "<thread>", "a stage starts no thread"),
        ("line/align/align.cpp", "<random>", "a stage draws no random number"),
        ("line/observation.h", '"line/match/match.h"', "the line's values know no stage"),
        ("sim/scene.cpp", '"contract/registers.h"', "registers are for who serves them"),
        ("serve/image.cpp", '"net/server.h"', "serve has no sockets"),
        ("serve/image.cpp", "<arpa/inet.h>", "serve has no sockets"),
        ("capture/worker.cpp", "<linux/videodev2.h>", "only devices sees V4L2"),
        ("app/run_command.cpp", "<linux/videodev2.h>", "only devices sees V4L2, whoever composes"),
        ("app/run_command.cpp", "<sys/socket.h>", "only net opens sockets"),
        ("app/run_command.cpp", "<netinet/in.h>", "only net opens sockets"),
        ("bench/load.cpp", "<boost/asio.hpp>", "only net sees Asio"),
        ("serve/image.cpp", "<boost/asio/write.hpp>", "only net sees Asio"),
        ("net/server.cpp", "<netdb.h>", "a header that nobody declared"),
        ("novel/thing.cpp", "<vector>", "a room that nobody declared"),
        ("thing.cpp", "<vector>", "a file in no room"),
    ],
)
def test_a_forbidden_include_is_refused(tmp_path: Path, file: str, include: str, why: str) -> None:
    found = check_layers.violations(plant(tmp_path, file, f"#include{include}\n"), ROOMS)
    assert len(found) == 1, why
    assert found[0].startswith(file)


@pytest.mark.parametrize(
    ("file", "include"),
    [
        ("line/gate/gate.cpp", '"line/pose/pose.h"'),
        ("line/gate/gate.cpp", "<line/measurement.h>"),
        ("line/gate/gate.cpp", "<vector>"),
        ("line/pose/pose.cpp", "<Eigen/LU>"),
        ("line/pose/pose.cpp", '"parts.h"'),
        ("devices/v4l2_driver.cpp", "  <linux/videodev2.h>  // its own"),
        ("app/main.cpp", '"net/modbus_server.h"'),
    ],
)
def test_an_allowed_include_is_accepted(tmp_path: Path, file: str, include: str) -> None:
    assert check_layers.violations(plant(tmp_path, file, f"#include {include}\n"), ROOMS) == []


def test_the_page_is_the_rule() -> None:
    granted = PAGE.replace("| `config` | outside text → the checked configuration | `document` |",
                           "| `config` | outside text → the checked configuration | `document`, `net` |")  # fmt: skip
    assert "net" not in ROOMS["config"]
    assert check_layers.rooms_of(granted)["config"] == ROOMS["config"] | {"net"}


@pytest.mark.parametrize(
    ("page", "complaint"),
    [
        ("# Architecture\n\n## Rooms\n\nNone.\n", "no table of rooms"),
        (PAGE.replace("## Rooms", "## Chambers"), "no table of rooms"),
        (PAGE.replace("| `sim` |", "| `devices` |"), "two rows"),
        (PAGE.replace("| `geometry`, `ports` |", "| `geometri`, `ports` |"), "'sim' may include what is no room"),
    ],
)
def test_a_page_that_is_no_rule_is_refused(page: str, complaint: str) -> None:
    with pytest.raises(check_layers.PageError, match=complaint):
        check_layers.rooms_of(page)


def test_every_row_of_the_page_is_a_folder() -> None:
    folders = {file.relative_to(TOP / "firmware").as_posix() for file in (TOP / "firmware").rglob("*")}
    assert set(ROOMS) - folders == {"line values"}


def test_every_room_that_may_see_an_outside_header_is_one() -> None:
    assert set().union(*outside_headers.ROOMS.values()) <= set(ROOMS)


Check = Callable[[], int]


@pytest.mark.parametrize("check", [check_layers.main, check_sizes.main])
def test_a_check_fails_on_a_planted_tree_and_passes_a_clean_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, check: Check
) -> None:
    monkeypatch.setattr(sys, "argv", ["check", str(tmp_path)])
    assert check() == 1, "a tree without a source file proves nothing"
    plant(tmp_path, "values/time.h", "#include <vector>\n")
    assert check() == 0
    plant(tmp_path, "values/side.h", '#include "net/server.h"\n' + "// line\n" * check_sizes.FILE_LINES)
    assert check() == 1


def test_the_size_check_without_a_folder_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["check_sizes.py"])
    assert check_sizes.main() == 2


def test_the_tree_keeps_its_layers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["check_layers.py"])
    assert check_layers.main() == 0


def test_a_long_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "long.h").write_text("// line\n" * (check_sizes.FILE_LINES + 1))
    assert len(check_sizes.violations([tmp_path])) == 1


def test_a_file_at_the_limit_is_accepted(tmp_path: Path) -> None:
    (tmp_path / "long.h").write_text("// line\n" * check_sizes.FILE_LINES)
    assert check_sizes.violations([tmp_path]) == []


@pytest.mark.parametrize(
    ("body", "word"),
    [
        ("int f() {\n" + "  g();\n" * 60 + "}\n", "lines"),
        ("int f(int a, int b, int c, int d, int e, int g) { return a; }\n", "parameters"),
        ("int f(int a) {\n" + "  if (a > 1) a += 1;\n" * 15 + "  return a;\n}\n", "complexity"),
    ],
)
def test_a_function_over_a_limit_is_refused(tmp_path: Path, body: str, word: str) -> None:
    (tmp_path / "big.cpp").write_text(body)
    found = check_sizes.violations([tmp_path])
    assert len(found) == 1
    assert word in found[0]
