"""Checks the sizes of style.md: files under 300 lines; functions at most 60 lines, 5 parameters, complexity 15.

usage: check_sizes.py FOLDER...
Prints one line for each violation and exits 1 when there is any. Functions are measured by lizard.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

import lizard

FILE_LINES = 300
FUNCTION_LINES = 60
PARAMETERS = 5
COMPLEXITY = 15
SUFFIXES = {".h", ".cpp", ".py"}


def violations(folders: Iterable[Path]) -> list[str]:
    found: list[str] = []
    for folder in folders:
        files = [file for file in sorted(folder.rglob("*")) if file.suffix in SUFFIXES and _is_ours(file)]
        if not files:
            found.append(f"{folder}: no source file here to check")
        for file in files:
            found += _of_file(file)
    return found


def _is_ours(file: Path) -> bool:
    return "build" not in file.parts and ".venv" not in file.parts


def _of_file(file: Path) -> list[str]:
    text = file.read_text()
    lines = text.count("\n")
    found = (
        [f"{file}: {lines} lines (limit {FILE_LINES}): a room that may hold two ideas"] if lines > FILE_LINES else []
    )
    for function in lizard.analyze_file.analyze_source_code(str(file), text).function_list:
        where = f"{file}:{function.start_line}: {function.name}"
        if function.length > FUNCTION_LINES:
            found.append(f"{where} has {function.length} lines (limit {FUNCTION_LINES})")
        if function.parameter_count > PARAMETERS:
            found.append(f"{where} has {function.parameter_count} parameters (limit {PARAMETERS})")
        if function.cyclomatic_complexity > COMPLEXITY:
            found.append(f"{where} has complexity {function.cyclomatic_complexity} (limit {COMPLEXITY})")
    return found


def main() -> int:
    if len(sys.argv) < 2:
        print("usage: check_sizes.py FOLDER...")
        return 2
    found = violations(Path(argument) for argument in sys.argv[1:])
    print("\n".join(found) if found else "every file and function is within its limit")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
