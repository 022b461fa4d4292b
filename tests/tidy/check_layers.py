"""Checks who may include whom: the table of ARCHITECTURE.md, held against every #include under firmware/.

usage: check_layers.py [FIRMWARE_FOLDER]
Prints one line for each violation and exits 1 when there is any.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

STAGES = ("align", "match", "pose", "gate", "monitor")

# room -> rooms it may include, itself apart. A room is a folder under firmware/; a stage of the line is line/<stage>.
ALLOWED: dict[str, set[str]] = {
    "values": set(),
    "ports": {"values"},
    "geometry": {"values"},
    "line/detect": {"values", "geometry", "ports", "line-values"},
    **{
        f"line/{stage}": {"values", "geometry", "line-values"} | {f"line/{earlier}" for earlier in STAGES[:n]}
        for n, stage in enumerate(STAGES)
    },
    "line-values": {"values", "geometry"},
    "line": {"values", "geometry", "line-values"} | {f"line/{stage}" for stage in STAGES},
    "capture": {"values", "geometry", "ports", "line/detect", "line-values"},
    "modulation": {"values", "geometry", "ports", "line/detect", "line/align", "line-values"},
    "document": {"values"},
    "calibration": {"values", "geometry", "document"},
    "config": {"values", "geometry", "document"},
    "devices": {"values", "geometry", "ports"},
    "sim": {"values", "geometry", "ports"},
    "explain": {"values", "ports", "line/detect", "line-values"},
    "recording": {"values", "geometry", "ports", "line-values", "document", "capture"},
    "serve": {"values", "geometry", "line-values", "calibration", "config"},
    "net": {"values", "serve"},
}
LINE_VALUES = {"observation.h", "model.h", "measurement.h"}
UNCHECKED = {"app", "bench", "fuzz"}  # they put everything together

# Headers that only one room may see.
ONLY_IN: dict[str, set[str]] = {
    "linux/videodev2.h": {"devices"},
    "gpiod.h": {"devices"},
    "libusb": {"devices"},
    "systemd/sd-daemon.h": {"devices"},
    "boost/": {"net"},
    "opencv2/": {"line/pose"},
    "jpeglib.h": {"capture", "sim", "recording"},
    "toml++/": {"document"},
    "openssl/": {"document", "net"},
    "sys/socket.h": {"net"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def room_of(path: str) -> str:
    """The room of a path relative to firmware/."""
    parts = path.split("/")
    if parts[0] != "line":
        return parts[0]
    if len(parts) > 2:
        return f"line/{parts[1]}"
    return "line-values" if parts[1] in LINE_VALUES else "line"


def violations(firmware: Path) -> list[str]:
    found: list[str] = []
    for file in sorted(firmware.rglob("*")):
        if file.suffix not in {".h", ".cpp"}:
            continue
        here = file.relative_to(firmware).as_posix()
        room = room_of(here)
        if room in UNCHECKED:
            continue
        if room not in ALLOWED:
            found.append(
                f"{here}: the room '{room}' is not in the table: add it to check_layers.py and ARCHITECTURE.md"
            )
            continue
        for quote, included in INCLUDE.findall(file.read_text()):
            found += _violation(here, room, included, own=quote == '"')
    return found


def _violation(here: str, room: str, included: str, *, own: bool) -> list[str]:
    if own:
        other = room_of(included) if "/" in included else room
        allowed = other == room or other in ALLOWED[room] or other == "contract"
        return [] if allowed else [f"{here}: the room '{room}' may not include '{included}' (room '{other}')"]
    return [
        f"{here}: only {', '.join(sorted(rooms))} may include <{included}>"
        for header, rooms in ONLY_IN.items()
        if included.startswith(header) and room not in rooms
    ]


def main() -> int:
    firmware = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "firmware"
    found = violations(firmware)
    print("\n".join(found) if found else "every include is allowed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
