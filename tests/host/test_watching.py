"""Following verdicts: each once, misses counted, silence shown; and the figures made of them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from host.staged import POSE, StagedClock, StagedUnit, answer, poses_numbered
from hypothesis import given
from hypothesis import strategies as st

from host_tool.contract.blocks import Identity, Pose
from host_tool.contract.conditions import Status
from host_tool.errors import UsageError
from host_tool.trajectories.paths import Path
from host_tool.watching.follow import POLL_S, SILENCE_S, Sighting, follow, missed_between
from host_tool.watching.session import Course, scenes
from host_tool.watching.speed import Speedometer
from host_tool.watching.tally import Tally
from host_tool.watching.truth import Comparison, check_comparable, compared

ORIGIN = Path("rest", 12.0, lambda t_s: np.tile([0.0, 0.0, 400.0], (len(t_s), 1)))
IDENTITY = Identity(1, 0, 1, "0.1.0", "led_position", 1, 1, "reference")


def seen(poses: list[Pose], seconds: float) -> list[Sighting]:
    return list(follow(StagedUnit(poses), StagedClock(), seconds))


def test_every_verdict_is_seen_once() -> None:
    sightings = seen(poses_numbered(5, 5, 6, 6, 6, 7), seconds=5.5 * POLL_S)
    assert [sighting.answer.pose.sequence for sighting in sightings] == [5, 6, 7]
    assert all(sighting.fresh and sighting.missed == 0 for sighting in sightings)


def test_verdicts_between_two_reads_are_counted_as_missed() -> None:
    assert [sighting.missed for sighting in seen(poses_numbered(5, 8, 9), seconds=2.5 * POLL_S)] == [0, 2, 0]


def test_silence_is_shown_again_and_again_as_nothing_new() -> None:
    sightings = seen(poses_numbered(5), seconds=2.2 * SILENCE_S)
    assert [sighting.fresh for sighting in sightings] == [True, False, False]


@given(st.integers(0, 2**32 - 1), st.integers(1, 1000))
def test_the_sequence_may_wrap(before: int, step: int) -> None:
    assert missed_between(before, (before + step) % 2**32) == step - 1


def test_a_restarted_unit_is_not_counted_as_missed_verdicts() -> None:
    assert missed_between(5000, 1) == 0


def test_a_pose_on_the_truth_is_inside() -> None:
    comparison = compared(POSE, ORIGIN)
    assert comparison is not None
    assert (comparison.error_mm, comparison.inside) == (0.0, True)


def turned_pose(angle_rad: float, status: Status = Status.POSITION_VALID | Status.ORIENTATION_VALID) -> Pose:
    """Turned about the line of sight, beyond the half turn about x in which the target faces the cameras."""
    half = angle_rad / 2.0
    return replace(POSE, status=status, quaternion_wxyz=(0.0, math.cos(half), math.sin(half), 0.0))


@pytest.mark.parametrize("angle_deg", [0.0, 1e-4, 0.5, 90.0, 180.0, 359.0])
def test_how_far_a_pose_is_turned_from_the_truth(angle_deg: float) -> None:
    comparison = compared(turned_pose(math.radians(angle_deg)), ORIGIN)
    assert comparison is not None
    assert comparison.turned_deg == pytest.approx(min(angle_deg, 360.0 - angle_deg), abs=1e-9)


def test_without_a_valid_orientation_nothing_is_turned() -> None:
    for pose in (POSE, turned_pose(0.1, Status.POSITION_VALID)):
        comparison = compared(pose, ORIGIN)
        assert comparison is not None
        assert comparison.turned_deg is None


def test_the_summary_adds_up_how_far_poses_were_turned() -> None:
    tally = Tally()
    for angle_rad in (0.3, 0.4):
        pose = turned_pose(angle_rad)
        tally.add(Sighting(answer(pose), 0.0, fresh=True, missed=0), compared(pose, ORIGIN))
    summary = tally.summary()
    assert summary.turned_rms_deg == pytest.approx(math.degrees(math.sqrt(0.125)))
    assert summary.turned_worst_deg == pytest.approx(math.degrees(0.4))


@pytest.mark.parametrize(("z_mm", "inside"), [(400.29, True), (400.31, False), (399.69, False)])
def test_one_axis_outside_its_interval_is_outside(z_mm: float, inside: bool) -> None:
    comparison = compared(replace(POSE, position_mm=(0.0, 0.0, z_mm)), ORIGIN)
    assert comparison is not None
    assert comparison.inside is inside
    assert comparison.error_mm == pytest.approx(abs(z_mm - 400.0))


def test_a_pose_that_is_not_valid_is_not_compared() -> None:
    assert compared(replace(POSE, status=0), ORIGIN) is None


def test_poses_in_another_frame_are_not_compared() -> None:
    with pytest.raises(UsageError, match=r"E-USE-02 .*robot_base"):
        check_comparable(replace(IDENTITY, output_frame="robot_base"))


def test_speed_is_the_way_over_the_time_of_exposure() -> None:
    speedometer = Speedometer()
    speeds = [
        speedometer.take(
            replace(POSE, position_mm=(2.5 * i, 0.0, 400.0), exposed_utc_ns=POSE.exposed_utc_ns + i * 10_000_000)
        )
        for i in range(100)
    ]
    assert speeds[0] is None
    assert speeds[1:] == pytest.approx([250.0] * 99)


def test_a_pose_without_position_ends_the_speed() -> None:
    speedometer = Speedometer()
    speedometer.take(POSE)
    assert speedometer.take(replace(POSE, status=0)) is None
    assert speedometer.take(replace(POSE, exposed_utc_ns=POSE.exposed_utc_ns + 1)) is None


def sighting(at_s: float, pose: Pose = POSE, missed: int = 0) -> Sighting:
    return Sighting(answer(pose), at_s, fresh=True, missed=missed)


def test_the_summary_of_nothing_knows_nothing() -> None:
    summary = Tally().summary()
    assert (summary.verdicts, summary.rate_hz, summary.valid_share, summary.rms_mm) == (0, None, None, None)


def test_the_summary_adds_up() -> None:
    tally = Tally()
    tally.add(sighting(10.0), Comparison((0.0, 0.0, 400.0), 3.0, inside=True))
    tally.add(sighting(10.5, missed=3), Comparison((0.0, 0.0, 400.0), 4.0, inside=False))
    tally.add(sighting(11.0, replace(POSE, status=0)), None)
    summary = tally.summary()
    assert (summary.verdicts, summary.missed, summary.poses) == (3, 3, 2)
    assert summary.rate_hz == pytest.approx(5.0)  # 5 steps in 1 s: two seen and three missed
    assert summary.valid_share == pytest.approx(2 / 3)
    assert summary.inside_share == pytest.approx(1 / 2)
    assert summary.rms_mm == pytest.approx(math.sqrt(12.5))
    assert summary.worst_mm == 4.0


def test_what_was_missed_before_counting_began_is_not_counted() -> None:
    tally = Tally()
    tally.add(sighting(10.0, missed=7), None)
    assert tally.summary().missed == 0


def test_the_figures_begin_after_settling() -> None:
    unit = StagedUnit(poses_numbered(*range(1000)))
    *_, last = scenes(unit, StagedClock(), Course(ORIGIN, settle_s=1.0, seconds=2.0))
    assert last.summary.verdicts == pytest.approx(1.0 / POLL_S, abs=2)  # 1 s; one more or less at each end by rounding
    assert last.summary.inside_share == 1.0


def test_a_following_says_for_how_long_it_has_seen_no_valid_position() -> None:
    blind = [replace(POSE, sequence=number, status=0) for number in (6, 7)]
    followed = scenes(
        StagedUnit([POSE, *blind, replace(POSE, sequence=8)]), StagedClock(), Course(seconds=3.5 * POLL_S)
    )
    assert [scene.without_s for scene in followed] == [None, 0.0, pytest.approx(POLL_S), None]
