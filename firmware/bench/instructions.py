"""Instructions that a program executes in one function, counted by callgrind: the same on every day."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path


def in_function(pattern: str, program: Path, *arguments: str) -> float:
    """Instructions per measured unit: the program prints how many units it ran through functions named `pattern`."""
    with tempfile.TemporaryDirectory() as folder:
        counts = Path(folder) / "callgrind"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", f"--toggle-collect={pattern}",
             program, *arguments],
            capture_output=True, check=False, text=True,
        )  # fmt: skip
        if run.returncode != 0:
            raise RuntimeError(f"{program.name} failed under callgrind:\n{run.stderr}")
        summary = next(line for line in counts.read_text().splitlines() if line.startswith("summary:"))
        counted = float(summary.split()[1])
        if counted == 0:
            raise RuntimeError(f"{program.name} never came to a function named {pattern}")
        return counted / float(run.stdout)
