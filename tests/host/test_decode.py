"""Blocks from raw words: the image is written by hand from the published map, in both word orders."""

import math

import pytest
from host.register_image import UTC_NS, Image, measuring_image
from hypothesis import given
from hypothesis import strategies as st

from host_tool.contract import decode
from host_tool.contract.conditions import Status
from host_tool.contract.register_map import register_map
from host_tool.contract.words import WordOrder
from host_tool.errors import DeviceError

ORDERS = pytest.mark.parametrize("order", list(WordOrder))
FLOAT32_STEP = 2.0**-23  # relative distance of two singles; half of it is the rounding of the image's floats


def words_at(image: Image, name: str, order: WordOrder = WordOrder.ABCD) -> decode.BlockWords:
    block = register_map().blocks[name]
    words = image.words if order is WordOrder.ABCD else image.mirrored()
    return decode.words_of(name, words[block.first : block.last + 1], order)


@ORDERS
def test_identity_is_read(order: WordOrder) -> None:
    identity = decode.identity_of(words_at(measuring_image(), "identity", order))
    assert (identity.serial_number, identity.firmware) == (4711, "0.2.9")
    assert (identity.mode, identity.output_frame) == ("led_position", "reference")
    assert (identity.calibration_id, identity.configuration_id) == (0xCAFE0001, 0xBEEF0002)


@ORDERS
def test_state_is_read(order: WordOrder) -> None:
    state = decode.state_of(words_at(measuring_image(), "state", order))
    assert (state.heartbeat, state.state, state.clients, state.uptime_s) == (99, "measuring", 3, 3600)


@ORDERS
def test_the_integer_pose_is_read_in_its_units(order: WordOrder) -> None:
    pose = decode.pose_of(words_at(measuring_image(), "measured", order))
    assert pose.position_mm == (-12.345, 6.789, 400.001)
    assert pose.uncertainty_mm == (0.12, 0.11, 0.3505)
    assert (pose.sequence, pose.exposed_utc_ns, pose.setup) == (70000, UTC_NS, 0xABCD)
    assert (pose.age_ms, pose.residual_px, pose.points_used) == (23.456, 0.051, 1)


@ORDERS
def test_the_float_pose_says_the_same_as_the_integer_pose(order: WordOrder) -> None:
    image = measuring_image()
    integers = decode.pose_of(words_at(image, "measured", order))
    floats = decode.pose_of(words_at(image, "measured_float", order))
    assert floats.position_mm == pytest.approx(integers.position_mm, rel=FLOAT32_STEP)
    assert floats.uncertainty_mm == pytest.approx(integers.uncertainty_mm, rel=FLOAT32_STEP)
    assert (floats.sequence, floats.exposed_utc_ns) == (integers.sequence, integers.exposed_utc_ns)
    assert floats.angles_deg is None
    assert floats.quaternion_wxyz is None


def test_what_the_unit_calls_unknown_is_none() -> None:
    image = measuring_image(status=0)
    image.put(108, "I", 0xFFFFFFFF)
    image.put(110, "i", *[-(1 << 31)] * 3)
    image.put(130, "I", *[0xFFFFFFFF] * 3)
    image.put(142, "H", 0xFFFF)
    pose = decode.pose_of(words_at(image, "measured"))
    assert (pose.age_ms, pose.position_mm, pose.uncertainty_mm, pose.residual_px) == (None, None, None, None)


@pytest.mark.parametrize("address", [110, 112, 114])
def test_half_a_position_is_none(address: int) -> None:
    image = measuring_image()
    image.put(address, "i", -(1 << 31))
    assert decode.pose_of(words_at(image, "measured")).position_mm is None


@pytest.mark.parametrize(
    ("status", "valid"),
    [
        (Status.POSITION_VALID, True),
        (Status.POSITION_VALID | Status.SIMULATED | Status.DEGRADED, True),
        (Status.POSITION_VALID | Status.STALE, False),
        (Status.TRACKING, False),
    ],
)
def test_a_position_is_valid_by_the_rule_for_clients(status: Status, valid: bool) -> None:
    pose = decode.pose_of(words_at(measuring_image(status=int(status)), "measured"))
    assert pose.position_valid is valid


def test_a_torn_block_is_refused() -> None:
    image = measuring_image()
    image.put(147, "H", 70001 & 0xFFFF)
    with pytest.raises(DeviceError, match="E-DEV-03"):
        decode.pose_of(words_at(image, "measured"))


def test_torn_points_are_refused() -> None:
    image = measuring_image()
    image.put(622, "H", 1)
    with pytest.raises(DeviceError, match="E-DEV-03"):
        decode.points_of(words_at(image, "points"))


def test_another_magic_is_no_tripoint() -> None:
    image = measuring_image()
    image.put(0, "H", 0x1234)
    with pytest.raises(DeviceError, match="E-DEV-01"):
        decode.identity_of(words_at(image, "identity"))


def test_another_major_version_is_refused() -> None:
    image = measuring_image()
    image.put(1, "H", 2)
    with pytest.raises(DeviceError, match="E-DEV-02"):
        decode.identity_of(words_at(image, "identity"))


@ORDERS
def test_points_are_read(order: WordOrder) -> None:
    (point,) = decode.points_of(words_at(measuring_image(), "points", order))
    assert (point.identity, point.position_mm, point.uncertainty_mm) == (1, (-12.345, 6.789, 400.001), 0.351)
    assert (point.saturated, point.weak) == (False, True)


@ORDERS
def test_cameras_and_timing_are_read(order: WordOrder) -> None:
    image = measuring_image()
    health = decode.health_of(*(words_at(image, name, order) for name in ("left_camera", "right_camera", "timing")))
    assert (health.left.temperature_c, health.right.temperature_c) == (None, 41.5)
    assert (health.left.rate_hz, health.left.exposure_us, health.left.dropped_frames) == (29.97, 1000, 7)
    assert (health.timing.skew_us, health.timing.skew_cost_mm, health.timing.latency_p99_us) == (-1500, 0.375, 980)
    assert (health.right.above_dim, health.right.below_clipping) == (2.1, 11.8)
    assert (health.timing.side_length_error_mm, health.timing.decalibration_mm) == (-0.005, None)


@pytest.mark.parametrize("raw", [0, 0xFFFF])  # a unit with map 1.0 leaves the registers at 0; no spot
def test_an_unknown_margin_of_the_exposure_is_none(raw: int) -> None:
    image = measuring_image()
    image.put(713, "H", raw, raw)
    health = decode.health_of(*(words_at(image, name) for name in ("left_camera", "right_camera", "timing")))
    assert (health.left.above_dim, health.left.below_clipping) == (None, None)


@given(st.lists(st.integers(0, 0xFFFF), min_size=48, max_size=48), st.sampled_from(WordOrder))
def test_no_words_make_a_pose_that_is_not_finite(words: list[int], order: WordOrder) -> None:
    words[-1] = words[0]
    for block in ("measured", "measured_float", "predicted"):
        pose = decode.pose_of(decode.words_of(block, words, order))
        for triple in (pose.position_mm, pose.uncertainty_mm, pose.angles_deg, pose.quaternion_wxyz):
            assert triple is None or all(math.isfinite(value) for value in triple)
