"""Trajectory files: written and read back, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from host_tool.errors import UsageError
from host_tool.trajectories.paths import SCENARIOS
from host_tool.trajectories.table import lines_of, path_from_file

HEADER = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz"


def written(folder: Path, *lines: str) -> Path:
    file = folder / "trajectory.csv"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


def test_rows_have_the_published_header_and_face_the_cameras() -> None:
    header, first, *rest = lines_of(SCENARIOS["paper-linear"], rate_hz=10.0, seconds=12.0)
    assert header == HEADER
    assert first == "0.000000,-20.000000,-50.000000,395.000000,0,1,0,0"
    assert len(rest) == 120


@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_a_written_scenario_reads_back_as_the_same_path(name: str, tmp_path: Path) -> None:
    path = SCENARIOS[name]
    again = path_from_file(written(tmp_path, *lines_of(path, rate_hz=1000.0, seconds=path.period_s)))
    times_s = np.linspace(0.0, 2.5 * path.period_s, 997)
    # Linear between rows: at most v a^2 / 8 of bending with 1 ms rows; the static volume's quickest move, 160 mm
    # in 1 s with least jerk, accelerates at most 5.8 * 160 mm/s^2: 1.2e-4 mm. Six digits add 5e-7 mm.
    assert again.positions_mm(times_s) == pytest.approx(path.positions_mm(times_s), abs=2e-4)
    assert again.period_s == pytest.approx(path.period_s)


def test_a_file_that_does_not_start_at_0_repeats_from_its_first_row(tmp_path: Path) -> None:
    path = path_from_file(written(tmp_path, HEADER, "10,0,0,400,1,0,0,0", "14,8,0,400,1,0,0,0"))
    assert path.positions_mm(np.array([1.0, 5.0]))[:, 0] == pytest.approx([2.0, 2.0])


def test_between_rows_the_target_turns_evenly(tmp_path: Path) -> None:
    half = np.sqrt(0.5)  # a quarter turn about z, its quaternion with the other sign
    path = path_from_file(written(tmp_path, HEADER, "0,0,0,400,1,0,0,0", f"2,0,0,400,{-half},0,0,{-half}"))
    for t_s, degrees in ((0.0, 0.0), (0.5, 22.5), (1.0, 45.0), (1.999, 89.955)):
        w, x, y, z = path.attitudes_wxyz(np.array([t_s]))[0]
        assert (x, y) == (0.0, 0.0)
        assert np.degrees(2.0 * np.arctan2(z, w)) == pytest.approx(degrees)


def test_a_target_at_rest_keeps_its_attitude(tmp_path: Path) -> None:
    path = path_from_file(written(tmp_path, HEADER, "0,0,0,400,0,1,0,0", "1,8,0,400,0,1,0,0"))
    assert path.attitudes_wxyz(np.array([0.3]))[0].tolist() == [0.0, 1.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("lines", "error"),
    [
        (("t,x,y,z",), "E-TRJ-03 .*line 1"),
        ((), "E-TRJ-03"),
        ((HEADER, "0,0,0,400,1,0,0,0", "1,0,0,400,1,0,0"), "E-TRJ-04 .*line 3"),
        ((HEADER, "0,0,0,nan,1,0,0,0"), "E-TRJ-04 .*line 2"),
        ((HEADER, "0,0,zero,400,1,0,0,0"), "E-TRJ-04 .*line 2"),
        ((HEADER, "0,0,0,400,1,0,0,0"), "E-TRJ-05"),
        ((HEADER, "0,0,0,400,1,0,0,0.1", "1,0,0,400,1,0,0,0"), "E-TRJ-04 .*line 2.*length 1.00499"),
        ((HEADER,), "E-TRJ-05"),
        ((HEADER, "1,0,0,400,1,0,0,0", "1,0,0,400,1,0,0,0"), "E-TRJ-05"),
    ],
)
def test_a_file_that_is_no_trajectory_is_refused(lines: tuple[str, ...], error: str, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=error):
        path_from_file(written(tmp_path, *lines))


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="E-TRJ-02"):
        path_from_file(tmp_path / "none.csv")


def test_a_file_of_other_bytes_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "picture.csv"
    file.write_bytes(b"\xff\xd8\xff\xe0")
    with pytest.raises(UsageError, match="E-TRJ-02"):
        path_from_file(file)
