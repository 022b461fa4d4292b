"""The checks of the code are checked: each must refuse a planted violation and accept the tree as it is."""

from __future__ import annotations

from pathlib import Path

import check_layers
import check_sizes
import pytest

TOP = Path(__file__).parents[2]


@pytest.mark.parametrize(
    ("file", "include", "why"),
    [
        ("values/time.h", '"geometry/rig.h"', "values knows nobody"),
        ("geometry/rig.cpp", '"ports/frame.h"', "geometry is pure"),
        ("line/match/match.cpp", '"line/gate/gate.h"', "a stage knows only the stages before it"),
        ("line/pose/pose.cpp", '"capture/mjpeg_decoder.h"', "a stage does no I/O"),
        ("serve/image.cpp", '"net/server.h"', "serve has no sockets"),
        ("capture/worker.cpp", "<linux/videodev2.h>", "only devices sees V4L2"),
        ("serve/image.cpp", "<boost/asio.hpp>", "only net sees Asio"),
        ("novel/thing.cpp", "<vector>", "a room that nobody declared"),
    ],
)
def test_a_forbidden_include_is_refused(tmp_path: Path, file: str, include: str, why: str) -> None:
    planted = tmp_path / file
    planted.parent.mkdir(parents=True)
    planted.write_text(f"#include {include}\n")
    found = check_layers.violations(tmp_path)
    assert len(found) == 1, why
    assert found[0].startswith(file)


def test_an_allowed_include_is_accepted(tmp_path: Path) -> None:
    planted = tmp_path / "line/gate/gate.cpp"
    planted.parent.mkdir(parents=True)
    planted.write_text('#include "line/pose/pose.h"\n#include "line/measurement.h"\n#include <vector>\n')
    assert check_layers.violations(tmp_path) == []


def test_the_tree_keeps_its_layers() -> None:
    assert check_layers.violations(TOP / "firmware") == []


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
