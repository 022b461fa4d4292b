"""Trajectory files: CSV with the header t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz, the target in the reference frame."""

import csv
import math
from collections.abc import Iterable, Iterator
from pathlib import Path as FilePath

import numpy as np

from host_tool.errors import UsageError
from host_tool.trajectories.paths import FACING_CAMERAS_WXYZ, Floats, Path

LENGTH_TOLERANCE = 1e-3  # of a quaternion, for the digits of a file
HEADER = ("t_s", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz")


def lines_of(path: Path, rate_hz: float, seconds: float) -> Iterator[str]:
    """The path sampled at `rate_hz` from t = 0 to `seconds` inclusive; nm resolution, facing the cameras."""
    yield ",".join(HEADER)
    rotation = ",".join(f"{part:g}" for part in FACING_CAMERAS_WXYZ)
    times_s = np.arange(round(seconds * rate_hz) + 1) / rate_hz
    for t_s, (x_mm, y_mm, z_mm) in zip(times_s, path.positions_mm(times_s), strict=True):
        yield f"{t_s:.6f},{x_mm:.6f},{y_mm:.6f},{z_mm:.6f},{rotation}"


def path_from_file(file: FilePath) -> Path:
    """A file as a path that repeats after its last row: linear between rows, turning evenly.

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

    def attitudes_wxyz(t_s: Floats) -> Floats:
        phase_s = np.mod(t_s, period_s)
        before = np.clip(np.searchsorted(times_s, phase_s, side="right") - 1, 0, len(times_s) - 2)
        share = (phase_s - times_s[before]) / (times_s[before + 1] - times_s[before])
        return _slerp(rows[before, 4:], rows[before + 1, 4:], share)

    return Path(file.name, period_s, positions_mm, attitudes_wxyz)


def _slerp(start_wxyz: Floats, end_wxyz: Floats, share: Floats) -> Floats:
    """Unit quaternions (n, 4) on the shorter great arc (Shoemake 1985)."""
    cosine = np.sum(start_wxyz * end_wxyz, axis=1)
    end_wxyz = np.where(cosine < 0.0, -1.0, 1.0)[:, np.newaxis] * end_wxyz
    angle = np.arccos(np.clip(np.abs(cosine), 0.0, 1.0))
    near = angle < 1e-6  # there the arc is a line
    sine = np.where(near, 1.0, np.sin(angle))
    from_start = np.where(near, 1.0 - share, np.sin((1.0 - share) * angle) / sine)[:, np.newaxis]
    from_end = np.where(near, share, np.sin(share * angle) / sine)[:, np.newaxis]
    mixed: Floats = from_start * start_wxyz + from_end * end_wxyz
    return mixed


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
    length = math.hypot(*row[4:])
    if abs(length - 1.0) > LENGTH_TOLERANCE:
        raise UsageError("E-TRJ-04", f"{file} line {line}: quaternion of length {length:g}", "give one of length 1")
    return [*row[:4], *(part / length for part in row[4:])]
