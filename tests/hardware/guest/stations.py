"""Where the target truly is in the pictures: runs of pictures in which it stands still, from truth.csv."""

import csv
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

Position = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Station:
    first: int  # number of its first picture
    count: int
    position_mm: Position  # of the target's origin, in the reference frame


def stations_of(recording: Path) -> list[Station]:
    with (recording / "truth.csv").open() as file:
        positions = [position_from(row) for row in csv.DictReader(file)]
    stations = []
    first = 0
    for position, run in groupby(positions):
        count = len(list(run))
        stations.append(Station(first, count, position))
        first += count
    return stations


def position_from(row: dict[str, str]) -> Position:
    return (float(row["x_mm"]), float(row["y_mm"]), float(row["z_mm"]))
