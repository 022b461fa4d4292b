"""A suite leaves its line in the summary when it passed, and ends the run when it did not."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

TESTS = Path(__file__).parents[1]


def run(tree: Path, suite: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([tree / "tests/run", suite], capture_output=True, text=True, check=False)


def tree_whose_machine(folder: Path, does: str) -> Path:
    """A checkout with the virtual machine's tests replaced by a shell command."""
    machine = folder / "tests/hardware/run"
    machine.parent.mkdir(parents=True)
    shutil.copy(TESTS / "run", folder / "tests/run")
    machine.write_text(f"#!/bin/sh\n{does}\n")
    machine.chmod(0o755)
    return folder


def test_the_hardware_test_has_its_line_in_the_summary(tmp_path: Path) -> None:
    tree = tree_whose_machine(tmp_path, "echo took 160 s; echo 'hardware-test: 16 passed, 0 failed'")
    assert run(tree, "hardware").returncode == 0
    assert run(tree, "summary").stdout.splitlines() == ["", "summary", "hardware 16 passed, 0 failed"]


def test_a_failed_hardware_test_ends_the_run_without_a_line(tmp_path: Path) -> None:
    tree = tree_whose_machine(tmp_path, "echo 'hardware-test: 0 passed, 1 failed (no kernel)'; exit 1")
    assert run(tree, "hardware").returncode == 1
    assert not list((tree / "build/summaries").iterdir())
