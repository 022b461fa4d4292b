"""A skipped test is never counted as passed: ctest itself runs small tests, and its own report is judged."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import ctest_verdict
import pytest

SKIPPED = "line_test.cpp:49: Skipped\\n{reason}\\n[  SKIPPED ] LineTest.Names (0 ms)\\n"
NO_DATA = "no such folder: /data; set TRIPOINT_SHARED"


def report(folder: Path, *tests: str) -> Path:
    """The report of ctest on these shell commands; one that prints SKIPPED skips itself, as GoogleTest does."""
    lines = []
    for number, command in enumerate(tests):
        lines.append(f'add_test(room.Test{number} "sh" "-c" [=[{command}]=])')
        lines.append(
            f'set_tests_properties(room.Test{number} PROPERTIES SKIP_REGULAR_EXPRESSION "\\\\[  SKIPPED \\\\]")'
        )
    (folder / "CTestTestfile.cmake").write_text("\n".join(lines) + "\n")
    written = folder / "ctest.xml"
    subprocess.run(
        ["ctest", "--test-dir", str(folder), "--output-junit", str(written)], capture_output=True, check=False
    )
    return written


def skip(reason: str) -> str:
    return f"printf '{SKIPPED.format(reason=reason)}'"


def verdict(monkeypatch: pytest.MonkeyPatch, written: Path) -> int:
    monkeypatch.setattr(sys, "argv", ["ctest_verdict.py", str(written)])
    return ctest_verdict.main()


def test_skipped_tests_are_counted_and_named_with_their_reason(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    written = report(tmp_path, "true", skip("nothing can be counted"), skip(NO_DATA), skip(NO_DATA))
    assert verdict(monkeypatch, written) == 0
    assert capsys.readouterr().out.splitlines() == [
        "skipped: room.Test1: nothing can be counted",
        f"skipped: room.Test2: {NO_DATA}",
        f"skipped: room.Test3: {NO_DATA}",
        "1 tests passed, 0 failed, 3 skipped; nothing was proved on the data that 2 of these lack: set TRIPOINT_SHARED",
    ]


def test_without_a_skip_the_summary_says_none(tmp_path: Path) -> None:
    found = ctest_verdict.outcomes(report(tmp_path, "true", "true").read_text())
    assert ctest_verdict.summary(found) == "2 tests passed, 0 failed, 0 skipped"


@pytest.mark.parametrize(
    "tests",
    [["true", "false"], [skip(NO_DATA)], ["true", "kill -9 $$"], []],
    ids=["failed", "skipped", "killed", "none"],
)
def test_a_run_that_proved_nothing_or_the_contrary_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tests: list[str]
) -> None:
    assert verdict(monkeypatch, report(tmp_path, *tests)) == 1


def test_a_program_that_is_missing_is_a_failure_not_a_skip(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written = report(tmp_path, "true")
    (tmp_path / "CTestTestfile.cmake").write_text('add_test(room.Test0 "true")\nadd_test(room.Test1 "/nowhere/test")\n')
    subprocess.run(
        ["ctest", "--test-dir", str(tmp_path), "--output-junit", str(written)], capture_output=True, check=False
    )
    assert verdict(monkeypatch, written) == 1
