"""What `make bench` prints of the figures in build/bench.json."""

from __future__ import annotations

from typing import Any

SIZES = ("320x240", "640x480", "720p")


def _of_pair(name: str) -> list[str]:
    return [f"{name}_320x240_vs_textbook", f"{name}_vs_textbook", f"{name}_720p_vs_textbook"]


def _of_clutter(name: str, row: str) -> list[str]:
    of_vga = name if row == "yuyv" else f"{name}_640_{row}"
    return [f"{name}_320_{row}", of_vga, f"{name}_1280_{row}"]


AT_EVERY_SIZE = {  # how a figure is called at 320x240, 640x480 and 1280x720
    "scan vs textbook": [f"scan_{size}_vs_textbook" for size in SIZES],
    "scan vs read": [f"scan_{size}_vs_read" for size in SIZES],
    "scan in clutter vs textbook": [f"scan_clutter_{size}_vs_textbook" for size in SIZES],
    "scan in clutter vs read": [f"scan_clutter_{size}_vs_read" for size in SIZES],
    "detect vs textbook": [f"detect_{size}_vs_textbook" for size in SIZES],
    "detect in clutter vs textbook": [f"detect_clutter_{size}_vs_textbook" for size in SIZES],
    "instructions, YUYV pair vs textbook": _of_pair("pair_instructions"),
    "instructions, tracked MJPEG pair vs textbook": _of_pair("pair_tracking_instructions"),
    "MJPEG pair vs textbook": _of_pair("mjpeg_pair"),
    "tracked MJPEG pair vs textbook": _of_pair("mjpeg_pair_tracking"),
    "LEDs found in clutter, YUYV": _of_clutter("clutter_leds_found_share", "yuyv"),
    "LEDs found in clutter, MJPEG 4:2:2, quality 85": _of_clutter("clutter_leds_found_share", "422_q85"),
    "LEDs found in clutter, MJPEG 4:2:0, quality 70": _of_clutter("clutter_leds_found_share", "420_q70"),
    "in the stated 95 %, YUYV": _of_clutter("clutter_covered_share", "yuyv"),
    "in the stated 95 %, MJPEG 4:2:2, quality 85": _of_clutter("clutter_covered_share", "422_q85"),
    "in the stated 95 %, MJPEG 4:2:0, quality 70": _of_clutter("clutter_covered_share", "420_q70"),
    "false points in clutter, YUYV": _of_clutter("clutter_false_points", "yuyv"),
    "ghosts in clutter, YUYV": _of_clutter("clutter_ghost_points", "yuyv"),
}
_OF_CLUTTER = ("clutter_leds_found_share", "clutter_covered_share", "clutter_false_points", "clutter_ghost_points")


def table_of_sizes(figures: list[dict[str, Any]]) -> str:
    """The figures that depend on the size of the pictures, side by side."""
    values = {figure["name"]: figure["value"] for figure in figures}
    rows = [f"{'at every size':48} {'320x240':>9} {'640x480':>9} {'1280x720':>9}"]
    for what, names in AT_EVERY_SIZE.items():
        rows.append(f"{what:48} " + " ".join(f"{values[name]:9.4g}" for name in names))
    return "\n".join(rows)


def table(figures: list[dict[str, Any]]) -> str:
    """The figures with their goals; without those of other sizes, and of other rows of the table of bench_clutter."""
    of_other_sizes = {name for small, _, large in AT_EVERY_SIZE.values() for name in (small, large)}
    rows = [f"{'figure':42} {'value':>12} {'unit':9} {'goal':>10}"]
    for figure in figures:
        name, goal = figure["name"], figure["goal"] or ""
        of_other_row = name.startswith(_OF_CLUTTER) and name not in _OF_CLUTTER
        if not goal and (name in of_other_sizes or of_other_row):
            continue
        mark = "" if figure["reached"] else "  not reached"
        rows.append(f"{name:42} {figure['value']:12.4g} {figure['unit']:9} {goal:>10}{mark}")
    return "\n".join(rows)
