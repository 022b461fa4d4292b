"""Prints the share of each room's lines that the unit tests reach, the total as the last line.

usage: coverage_by_room.py SUMMARY       what `gcovr --json-summary` wrote, with firmware/ as its root
Exits 1 when no line was reached at all: then nothing was run.
"""

from __future__ import annotations

import json
import sys
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

from check_layers import room_of


@dataclass(frozen=True, slots=True)
class Reached:
    """How many of so many lines."""

    covered: int = 0
    lines: int = 0

    def __add__(self, other: Reached) -> Reached:
        return Reached(self.covered + other.covered, self.lines + other.lines)

    def __str__(self) -> str:
        share_percent = 100.0 * self.covered / self.lines if self.lines > 0 else 0.0
        return f"{share_percent:5.1f} % of {self.lines} lines"


def by_room(summary: str) -> dict[str, Reached]:
    rooms: defaultdict[str, Reached] = defaultdict(Reached)
    for file in json.loads(summary)["files"]:
        rooms[room_of(file["filename"])] += Reached(file["line_covered"], file["line_total"])
    return dict(sorted(rooms.items()))


def main() -> int:
    rooms = by_room(Path(sys.argv[1]).read_text(encoding="utf-8"))
    for room, reached in rooms.items():
        print(f"{room:<14}{reached}")
    total = sum(rooms.values(), Reached())
    print(f"unit tests reach {str(total).strip()}")
    return 0 if total.covered > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
