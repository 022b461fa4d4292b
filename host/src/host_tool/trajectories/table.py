"""Trajectory files: CSV with the header t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz, the target in the reference frame."""

import csv
from collections.abc import Iterable, Iterator
from pathlib import Path as FilePath

import numpy as np

from host_tool.errors import UsageError
from host_tool.trajectories.paths import FACING_CAMERAS_WXYZ, Floats, Path

HEADER = ("t_s", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz")


def lines_of(path: Path, rate_hz: float, seconds: float) -> Iterator[str]:
    """The path sampled at `rate_hz` from t = 0 to `seconds` inclusive; nm resolution, facing the cameras."""
    yield ",".join(HEADER)
    rotation = ",".join(f"{part:g}" for part in FACING_CAMERAS_WXYZ)
    times_s = np.arange(round(seconds * rate_hz) + 1) / rate_hz
    for t_s, (x_mm, y_mm, z_mm) in zip(times_s, path.positions_mm(times_s), strict=True):
        yield f"{t_s:.6f},{x_mm:.6f},{y_mm:.6f},{z_mm:.6f},{rotation}"


def path_from_file(file: FilePath) -> Path:
    """A file as a path that repeats after its last row, linear between rows.

    Raises UsageError: E-TRJ-02 unreadable, E-TRJ-03 header, E-TRJ-04 a row, E-TRJ-05 times not rising.
    """
    try:
        with file.open(newline="", encoding="utf-8") as lines:
            rows = _rows_from(file, lines)
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError("E-TRJ-02", f"cannot read {file}", f"check the path ({error})") from error
    times_s = rows[:, 0] - rows[0, 0]
    period_s = float(times_s[-1])

    def positions_mm(t_s: Floats) -> Floats:
        phase_s = np.mod(t_s, period_s)
        return np.column_stack([np.interp(phase_s, times_s, rows[:, column]) for column in (1, 2, 3)])

    return Path(file.name, period_s, positions_mm)


def _rows_from(file: FilePath, lines: Iterable[str]) -> Floats:
    reader = csv.reader(lines)
    if tuple(next(reader, ())) != HEADER:
        raise UsageError("E-TRJ-03", f"{file} line 1 is not the header", f"write {','.join(HEADER)}")
    rows = [_row_from(file, reader.line_num, cells) for cells in reader]
    table = np.array(rows, dtype=np.float64)
    if len(rows) < 2 or not np.all(np.diff(table[:, 0]) > 0.0):
        raise UsageError("E-TRJ-05", f"{file} has no rising times", "give at least two rows with t_s rising")
    return table


def _row_from(file: FilePath, line: int, cells: list[str]) -> list[float]:
    try:
        row = [float(cell) for cell in cells]
    except ValueError:
        row = []
    if len(row) != len(HEADER) or not np.all(np.isfinite(row)):
        raise UsageError("E-TRJ-04", f"{file} line {line} is not a row", f"give {len(HEADER)} finite numbers")
    return row
