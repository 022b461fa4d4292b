"""The shipped scenarios as closed forms: where the target is at any time, in the reference frame.

Every path repeats with its period, and its time is UTC modulo that period: the truth of a pose follows from
the exposure time that the pose carries. On the paper's paths the speed is constant and turns around at the ends.
The unit's simulation uses the same closed forms; tests/contract compares the two.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from host_tool.errors import UsageError

Floats = NDArray[np.float64]

FACING_CAMERAS_WXYZ = (0.0, 1.0, 0.0, 0.0)  # half a turn about x: the target's shining side looks at the cameras

_LEG_S = 6.0  # one way, as in the paper
_SCOUT_LEG_S = 3.0
_STAY_S = 3.0  # at a station and on the way to the next
_HOLD_S = 2.0  # of these at rest
_NS_PER_S = 1_000_000_000


def facing_cameras_wxyz(t_s: Floats) -> Floats:
    """The attitude of the shipped scenarios at all times."""
    return np.tile(np.array(FACING_CAMERAS_WXYZ), (len(t_s), 1))


@dataclass(frozen=True, slots=True)
class Path:
    """A periodic motion; the functions map times (n) to positions (n, 3) and to unit quaternions (n, 4)."""

    name: str
    period_s: float
    positions_mm: Callable[[Floats], Floats]
    attitudes_wxyz: Callable[[Floats], Floats] = facing_cameras_wxyz

    def position_at_utc_mm(self, utc_ns: int) -> Floats:
        """Position at a UTC time."""
        position: Floats = self.positions_mm(self._phase_s(utc_ns))[0]
        return position

    def attitude_at_utc_wxyz(self, utc_ns: int) -> Floats:
        """Unit quaternion at a UTC time."""
        attitude: Floats = self.attitudes_wxyz(self._phase_s(utc_ns))[0]
        return attitude

    def _phase_s(self, utc_ns: int) -> Floats:
        """Reduced in integers, since ns since 1970 exceed a double's precision."""
        return np.array([(utc_ns % round(self.period_s * _NS_PER_S)) / _NS_PER_S])


def _there_and_back(t_s: Floats, leg_s: float) -> Floats:
    """0 to 1 in one leg, then back to 0, for ever: a triangle wave of constant slope."""
    phase = np.mod(t_s, 2.0 * leg_s) / leg_s
    return np.where(phase <= 1.0, phase, 2.0 - phase)


def paper_linear_mm(t_s: Floats) -> Floats:
    """Straight from (-20, -50, 395) by (40, 100, 10) mm in 6 s, then back."""
    start_mm = np.array([-20.0, -50.0, 395.0])
    way_mm = np.array([40.0, 100.0, 10.0])
    path_mm: Floats = start_mm + _there_and_back(t_s, _LEG_S)[:, np.newaxis] * way_mm
    return path_mm


def paper_circular_mm(t_s: Floats) -> Floats:
    """Half circle from Pi (-68.5, 68, 385) to Pf (-60.5, -93, 476) mm in 6 s, then back the same way.

    The chord Pi-Pf is the diameter. The plane is spanned by the chord and +x made perpendicular to the chord,
    and the arc bulges to that side: p = C + r (cos(pi s) e + sin(pi s) n), with C the middle of the chord,
    e the unit vector from C to Pi, n the unit vector of x - (x . e) e, and s the share of the way.
    """
    start_mm = np.array([-68.5, 68.0, 385.0])
    end_mm = np.array([-60.5, -93.0, 476.0])
    center_mm = (start_mm + end_mm) / 2.0
    radius_mm = float(np.linalg.norm(start_mm - center_mm))
    along = (start_mm - center_mm) / radius_mm
    bulge = np.array([1.0, 0.0, 0.0]) - along[0] * along
    bulge /= np.linalg.norm(bulge)
    angle_rad = np.pi * _there_and_back(t_s, _LEG_S)[:, np.newaxis]
    path_mm: Floats = center_mm + radius_mm * (np.cos(angle_rad) * along + np.sin(angle_rad) * bulge)
    return path_mm


def scout_mm(t_s: Floats) -> Floats:
    """The tip of the paper's wheeled manipulator (Eq. 18 and 19, Table III), in 3 s and back.

    The base drives 1 m while the joints turn from -180 and -90 to -45 and 45 degrees; links of 0.16 and 0.21 m.
    The real path is 1.5 m long: here it has a tenth of its size, upright in the plane z = 400 mm, with the middle
    between its first and last tip on the z axis (rounded to 0.01 mm of the real path).
    """
    share = _there_and_back(t_s, _SCOUT_LEG_S)
    upper_rad = np.pi * (0.75 * share - 1.0)
    fore_rad = upper_rad + np.pi * (0.75 * share - 0.5)
    x_m = share + 0.16 * np.cos(upper_rad) + 0.21 * np.cos(fore_rad)
    y_m = 0.16 * np.sin(upper_rad) + 0.21 * np.sin(fore_rad)
    return np.column_stack([100.0 * (x_m - 0.58157), -100.0 * (y_m - 0.04843), np.full_like(x_m, 400.0)])


def volume_stations_mm() -> Floats:
    """27 places, 160 x 120 x 140 mm around (0, 0, 400), to and fro so that every move but the last is short."""
    stations, x_sign, y_sign = [], 1.0, 1.0
    for z_mm in (330.0, 400.0, 470.0):
        for y_mm in (-60.0, 0.0, 60.0):
            stations += [(x_sign * x_mm, y_sign * y_mm, z_mm) for x_mm in (-80.0, 0.0, 80.0)]
            x_sign = -x_sign
        y_sign = -y_sign
    return np.array(stations)


def static_volume_mm(t_s: Floats) -> Floats:
    """2 s at each of the 27 stations, 1 s with least jerk to the next, and from the last to the first."""
    stations_mm = volume_stations_mm()
    phase_s = np.mod(t_s, len(stations_mm) * _STAY_S)
    here = np.floor(phase_s / _STAY_S).astype(np.int64)
    s = np.clip((phase_s - here * _STAY_S - _HOLD_S) / (_STAY_S - _HOLD_S), 0.0, 1.0)[:, np.newaxis]
    share = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
    start_mm, end_mm = stations_mm[here], stations_mm[(here + 1) % len(stations_mm)]
    moved_mm: Floats = start_mm + share * (end_mm - start_mm)
    return moved_mm


SCENARIOS: dict[str, Path] = {
    path.name: path
    for path in (
        Path("paper-linear", 2.0 * _LEG_S, paper_linear_mm),
        Path("paper-circular", 2.0 * _LEG_S, paper_circular_mm),
        Path("scout", 2.0 * _SCOUT_LEG_S, scout_mm),
        Path("static-volume", 27 * _STAY_S, static_volume_mm),
        Path("bumped-camera", 3 * 2.0 * _LEG_S, paper_circular_mm),  # the cameras differ, not the path
    )
}


def scenario_from(name: str) -> Path:
    """A shipped scenario by its name; raises UsageError E-TRJ-01."""
    if name not in SCENARIOS:
        raise UsageError("E-TRJ-01", f"no scenario {name!r}", f"choose one of {', '.join(sorted(SCENARIOS))}")
    return SCENARIOS[name]
