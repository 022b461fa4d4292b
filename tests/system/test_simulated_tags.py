"""The unit on simulated cameras that see three AprilTags: mode 3, full poses, as near to the truth as they state."""

import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from system.daemon import REPOSITORY, Daemon, daemon, finished

from host_tool.appliance.unit import open_unit
from host_tool.clock import MonotonicClock
from host_tool.trajectories.paths import SCENARIOS
from host_tool.watching.session import Course, scenes

TAGS = REPOSITORY / "deploy/demo/apriltag.toml"
SETTLE_S = 5.0  # as the demo
LARGEST_TURN_DEG = 1.0  # 0.2 mm over the 60 mm of the target's shortest side are 0.2 degrees


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    with daemon(tmp_path_factory.mktemp("tags") / "log", config=TAGS) as started:
        time.sleep(SETTLE_S)
        yield started


def test_full_poses_of_tags_follow_the_truth_and_know_how_well(running: Daemon) -> None:
    with open_unit(running.address, 2.0) as unit:
        assert unit.identity.mode == "apriltag_pose"
        *_, last = scenes(unit, MonotonicClock(), Course(SCENARIOS["paper-circular"], seconds=6.0))
    assert last.summary.poses > 0
    assert last.summary.inside_share is not None
    assert last.summary.inside_share >= 0.85
    assert last.summary.turned_worst_deg is not None
    assert last.summary.turned_worst_deg < LARGEST_TURN_DEG


def test_a_tag_that_its_family_does_not_have_is_refused(tmp_path: Path) -> None:
    target = tmp_path / "target.toml"
    text = (TAGS.parent / "apriltag_target.toml").read_text(encoding="utf-8")
    target.write_text(text.replace("id = 2\n", "id = 587\n"), encoding="utf-8")
    refused = finished("check-config", str(TAGS), "--set", f"target.file={target}")
    assert refused.returncode == 2
    assert "587" in refused.stderr
