"""Checks who may include whom: the table of ARCHITECTURE.md, held against every #include under firmware/.

usage: check_layers.py [FIRMWARE_FOLDER]
Prints one line for each violation and exits 1 when there is any.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import outside_headers

TOP = Path(__file__).resolve().parents[2]
PAGE = TOP / "ARCHITECTURE.md"
SOURCES = {".h", ".hpp", ".c", ".cc", ".cpp", ".cxx", ".inc", ".ipp", ".tpp"}
LINE_VALUES = {"observation.h", "model.h", "measurement.h"}
EVERYTHING = "everything"

ROW = re.compile(r"^\| *(`[^|]*`) *\|[^|]*\|([^|]*)\|$", re.MULTILINE)
INCLUDE = re.compile(r"^\s*#\s*include(.*)$", re.MULTILINE)
INCLUDED = re.compile(r'\s*(?:"([^"]+)"|<([^>]+)>)')

Rooms = dict[str, set[str]]


class PageError(Exception):
    """The table of the page cannot be the rule."""


def rooms_of(page: str) -> Rooms:
    """Each room of the table with those it may include, itself and `values` among them."""
    section = page.partition("\n## Rooms\n")[2].partition("\n## ")[0]
    cells = [(name, friends) for names, friends in ROW.findall(section) for name in re.findall("`([^`]+)`", names)]
    if not cells:
        raise PageError("ARCHITECTURE.md: no table of rooms under '## Rooms'")
    names = {name for name, _ in cells}
    if len(names) != len(cells):
        raise PageError("ARCHITECTURE.md: a room has two rows in the table")
    rooms = {}
    for name, cell in cells:
        friends = names if cell.strip() == EVERYTHING else set(re.findall("`([^`]+)`", cell))
        if not friends <= names:
            raise PageError(f"ARCHITECTURE.md: '{name}' may include what is no room: {', '.join(friends - names)}")
        rooms[name] = friends | {name, "values"}
    return rooms


def room_of(path: str) -> str:
    """The room of a path relative to firmware/: its folder, or line/<stage>."""
    parts = path.split("/")
    if parts[0] != "line":
        return parts[0]
    if len(parts) > 2:
        return f"line/{parts[1]}"
    return "line values" if parts[1] in LINE_VALUES else "line"


def violations(firmware: Path, rooms: Rooms) -> list[str]:
    files = [file for file in sorted(firmware.rglob("*")) if file.suffix in SOURCES]
    if not files:
        return [f"{firmware}: no source file here to check"]
    found: list[str] = []
    for file in files:
        here = file.relative_to(firmware).as_posix()
        room = room_of(here)
        if room not in rooms:
            found.append(f"{here}: the room '{room}' has no row in the table of ARCHITECTURE.md")
            continue
        for rest in INCLUDE.findall(file.read_text(encoding="utf-8")):
            complaint = _complaint(room, rest, rooms)
            found += [f"{here}: {complaint}"] if complaint else []
    return found


def _complaint(room: str, rest: str, rooms: Rooms) -> str | None:
    """What is wrong with an include, given what follows the word; None when nothing is."""
    match = INCLUDED.match(rest)
    if match is None:
        return f"'#include{rest}' names no file: write it out"
    quoted, angled = match.groups()
    included = quoted or angled
    if quoted is None and not ("/" in included and room_of(included) in rooms):
        return outside_headers.complaint(room, included)
    other = room_of(included) if "/" in included else room
    return None if other in rooms[room] else f"the room '{room}' may not include '{included}' (room '{other}')"


def main() -> int:
    firmware = Path(sys.argv[1]) if len(sys.argv) > 1 else TOP / "firmware"
    try:
        found = violations(firmware, rooms_of(PAGE.read_text(encoding="utf-8")))
    except PageError as error:
        found = [str(error)]
    print("\n".join(found) if found else "every include is allowed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
