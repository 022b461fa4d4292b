"""The shipped scenarios against the numbers and properties that the paper gives."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from host_tool.errors import UsageError
from host_tool.trajectories.paths import SCENARIOS, Floats, scenario_from, volume_stations_mm

PI_MM, PF_MM = np.array([-68.5, 68.0, 385.0]), np.array([-60.5, -93.0, 476.0])
TIMES_S = st.floats(0.0, 100.0)
ROUNDING_MM = 1e-9  # a few hundred mm in double precision, and a dozen operations


def at(path_name: str, t_s: float) -> Floats:
    position_mm: Floats = SCENARIOS[path_name].positions_mm(np.array([t_s]))[0]
    return position_mm


@pytest.mark.parametrize(
    ("t_s", "position_mm"),
    [(0.0, (-20, -50, 395)), (6.0, (20, 50, 405)), (3.0, (0, 0, 400)), (9.0, (0, 0, 400)), (12.0, (-20, -50, 395))],
)
def test_the_line_goes_there_in_6_s_and_back(t_s: float, position_mm: tuple[float, ...]) -> None:
    assert at("paper-linear", t_s) == pytest.approx(position_mm, abs=ROUNDING_MM)


def test_the_circle_begins_and_ends_at_the_points_of_the_paper() -> None:
    assert at("paper-circular", 0.0) == pytest.approx(PI_MM, abs=ROUNDING_MM)
    assert at("paper-circular", 6.0) == pytest.approx(PF_MM, abs=ROUNDING_MM)
    assert at("paper-circular", 12.0) == pytest.approx(PI_MM, abs=ROUNDING_MM)


@given(TIMES_S)
def test_every_point_of_the_circle_sees_the_chord_at_a_right_angle(t_s: float) -> None:
    position_mm = at("paper-circular", t_s)  # Thales
    assert np.dot(position_mm - PI_MM, position_mm - PF_MM) == pytest.approx(0.0, abs=1e3 * ROUNDING_MM)


@given(TIMES_S)
def test_the_circle_lies_in_the_plane_of_its_chord_and_x_on_the_x_side(t_s: float) -> None:
    from_center_mm = at("paper-circular", t_s) - (PI_MM + PF_MM) / 2.0
    normal = np.cross(PF_MM - PI_MM, [1.0, 0.0, 0.0])
    assert np.dot(from_center_mm, normal / np.linalg.norm(normal)) == pytest.approx(0.0, abs=ROUNDING_MM)
    chord = (PF_MM - PI_MM) / np.linalg.norm(PF_MM - PI_MM)
    assert (from_center_mm - np.dot(from_center_mm, chord) * chord)[0] >= -ROUNDING_MM


@pytest.mark.parametrize(
    ("name", "length_mm"),
    [
        ("paper-linear", math.sqrt(40**2 + 100**2 + 10**2)),
        ("paper-circular", math.pi / 2 * math.sqrt(8**2 + 161**2 + 91**2)),
    ],
)
def test_speed_along_the_papers_paths_is_constant(name: str, length_mm: float) -> None:
    times_s = np.linspace(0.0, 6.0, 601)
    steps_mm = np.linalg.norm(np.diff(SCENARIOS[name].positions_mm(times_s), axis=0), axis=1)
    # A chord is shorter than its arc by angle^2 / 24, here (pi / 600)^2 / 24 = 1.1e-6.
    assert steps_mm == pytest.approx(np.full(600, length_mm / 600), rel=2e-6)


def test_the_scout_moves_its_tip_as_the_papers_kinematics_by_hand() -> None:
    # First: base 0, upper link along -x, fore link at -270 degrees: (-0.16, 0.21) m.
    # Last: base 1 m, upper link at -45 degrees, fore link along +x: (1 + 0.16 / sqrt 2 + 0.21, -0.16 / sqrt 2) m.
    way_mm = at("scout", 3.0) - at("scout", 0.0)
    down_mm = 100.0 * (0.16 / math.sqrt(2.0) + 0.21)  # y points down in the reference frame
    assert way_mm == pytest.approx([100.0 * (1.37 + 0.16 / math.sqrt(2.0)), down_mm, 0.0], abs=ROUNDING_MM)
    # Half way: base 0.5 m, upper link at -112.5 degrees, fore link at -135 degrees.
    x_m = 0.5 + 0.16 * math.cos(math.radians(-112.5)) + 0.21 * math.cos(math.radians(-135.0))
    assert at("scout", 1.5)[0] - at("scout", 0.0)[0] == pytest.approx(100.0 * (x_m + 0.16), abs=ROUNDING_MM)


def test_the_static_volume_rests_at_27_different_places() -> None:
    stations_mm = volume_stations_mm()
    assert len({tuple(station) for station in stations_mm}) == 27
    for place, station_mm in enumerate(stations_mm):
        for rest_s in (0.0, 1.0, 1.999):
            assert at("static-volume", 3.0 * place + rest_s) == pytest.approx(station_mm, abs=ROUNDING_MM)


def test_halfway_between_two_stations_is_the_middle() -> None:
    first_mm, second_mm = volume_stations_mm()[:2]
    assert at("static-volume", 2.5) == pytest.approx((first_mm + second_mm) / 2.0, abs=ROUNDING_MM)


def test_the_bumped_camera_sees_three_circles() -> None:
    assert SCENARIOS["bumped-camera"].period_s == pytest.approx(36.0)
    assert at("bumped-camera", 15.0) == pytest.approx(at("paper-circular", 3.0), abs=ROUNDING_MM)


@given(st.sampled_from(sorted(SCENARIOS)), st.integers(0, 3 * 10**7), st.integers(0, 5 * 10**9))
def test_utc_is_taken_modulo_the_period_without_losing_ns(name: str, periods: int, phase_ns: int) -> None:
    path = SCENARIOS[name]  # beyond 2^60 ns a double steps by 256 ns
    utc_ns = (periods + 10**8) * round(path.period_s * 1e9) + phase_ns
    assert path.position_at_utc_mm(utc_ns) == pytest.approx(at(name, phase_ns / 1e9), abs=ROUNDING_MM)


def test_an_unknown_scenario_names_those_that_exist() -> None:
    with pytest.raises(UsageError, match=r"E-TRJ-01 .*paper-circular, paper-linear, scout, static-volume"):
        scenario_from("square")
