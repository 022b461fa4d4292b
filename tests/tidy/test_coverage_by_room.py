"""Lines are summed by room, and a report of nothing is refused."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import coverage_by_room
import pytest


def summary(folder: Path, *files: tuple[str, int, int]) -> Path:
    """A summary as gcovr 5.2 writes it: file, lines reached, lines."""
    written = folder / "coverage.json"
    rows = [{"filename": name, "line_covered": covered, "line_total": total} for name, covered, total in files]
    written.write_text(json.dumps({"gcovr/summary_format_version": "0.5", "files": rows}))
    return written


def verdict(monkeypatch: pytest.MonkeyPatch, written: Path) -> int:
    monkeypatch.setattr(sys, "argv", ["coverage_by_room.py", str(written)])
    return coverage_by_room.main()


def test_lines_are_summed_by_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    files = [
        ("net/server.cpp", 90, 100),
        ("line/pose/pose.cpp", 30, 40),
        ("net/client.h", 0, 20),
        ("line/line.cpp", 40, 40),
    ]
    assert verdict(monkeypatch, summary(tmp_path, *files)) == 0
    assert capsys.readouterr().out.splitlines() == [
        "line          100.0 % of 40 lines",
        "line/pose      75.0 % of 40 lines",
        "net            75.0 % of 120 lines",
        "unit tests reach 80.0 % of 200 lines",
    ]


@pytest.mark.parametrize("files", [[], [("net/server.cpp", 0, 100)]])
def test_a_report_in_which_nothing_was_reached_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, files: list[tuple[str, int, int]]
) -> None:
    assert verdict(monkeypatch, summary(tmp_path, *files)) == 1
