"""What the unit is doing, in words that name the camera, what is missing and since when."""

from dataclasses import replace

import pytest
from host.staged import POSE, answer

from host_tool.cli.plight import doing
from host_tool.contract.blocks import Camera, Health, Timing
from host_tool.contract.register_map import register_map

CAMERA = Camera("delivering", 30.0, 2000.0, None, None, 0, 0, None, 20.0, None, 0, None, None)
HEALTH = Health(CAMERA, CAMERA, Timing(None, None, None, None, None, None, None, None, None, None))
LEFT, RIGHT, VOLUME = 1 << 3, 1 << 4, 1 << 8


def told(state: str, faults: int = 0, age_ms: float | None = 20.0, health: Health = HEALTH) -> str:
    seen = answer(replace(POSE, status=0, faults=faults, age_ms=age_ms))
    return doing(replace(seen, state=replace(seen.state, state=state, uptime_s=75)), health)


@pytest.mark.parametrize(
    ("faults", "words"),
    [
        (LEFT, "searching: the left camera does not see the target, the right one does;"),
        (RIGHT, "searching: the right camera does not see the target, the left one does;"),
        (LEFT | RIGHT, "searching: neither camera sees the target;"),
        (VOLUME, "searching: outside the working volume;"),
    ],
)
def test_searching_says_which_camera_lacks_what(faults: int, words: str) -> None:
    assert told("searching", faults).startswith(words)


def test_searching_says_since_when_as_far_as_the_registers_tell() -> None:
    assert told("searching", LEFT, age_ms=None).endswith("no position since the unit started 1 min 15 s ago")
    assert "it had a position before" in told("searching", LEFT)


def test_a_camera_that_does_not_deliver_is_named() -> None:
    away = replace(HEALTH, right=replace(CAMERA, state="missing"))
    assert told("camera_fault", health=away) == "camera fault: the right camera is not there"
    late = replace(HEALTH, left=replace(CAMERA, state="starting"))
    assert told("starting", health=late) == "starting: the left camera has not delivered a picture yet"


def test_a_real_camera_that_was_never_opened_is_told_from_one_that_went_away() -> None:
    never = replace(CAMERA, state="missing", exposure_us=None)
    words = told("camera_fault", health=replace(HEALTH, left=never))
    assert words.startswith("camera fault: the left camera has not been opened since the unit started")
    assert "[cameras.left]" in words
    recording = answer(POSE)
    simulated = replace(recording, state=replace(recording.state, state="camera_fault"))
    assert doing(simulated, replace(HEALTH, left=never)) == "camera fault: the left camera is not there"


def test_every_state_of_the_map_has_words() -> None:
    for meaning in register_map().choices["state"]:
        assert told(meaning.name).startswith(meaning.name.replace("_", " "))
