"""`tripointd replay` on drawn pictures of an AprilTag, against the pose with which they were drawn."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from system.daemon import CONFIG, finished
from system.pictures import png

CODE = 0xD5D628584  # id 0 of tag36h11 as published with AprilTag 2: 36 bits row by row, 1 is light
SIZE_MM = 60.0
FOCAL_PX, CENTRE_PX = 628.0, np.array([320.0, 240.0])
BASELINE_MM = 100.0
FRAME_NS = 33_333_333
SAMPLES = 6  # of a pixel, to each side
WINDOW_PX = 180  # holds the tag and its light rim
PLACE_MM = np.array([20.0, -10.0, 410.0])  # of the tag's centre, in the reference frame

CALIBRATION = """format = "tripoint-calibration/1"
created = 2026-11-25T12:00:00Z
[cameras.left]
serial = ""
port = "1"
width_px = 640
height_px = 480
focal_px = [628.0, 628.0]
center_px = [320.0, 240.0]
distortion = [0.0, 0.0, 0.0, 0.0, 0.0]
[cameras.right]
serial = ""
port = "2"
width_px = 640
height_px = 480
focal_px = [628.0, 628.0]
center_px = [320.0, 240.0]
distortion = [0.0, 0.0, 0.0, 0.0, 0.0]
[right_from_left]
rotation_rad = [0.0, 0.0, 0.0]
translation_mm = [-100.0, 0.0, 0.0]
"""
TARGET = """format = "tripoint-target/1"
detector = "apriltag"
family = "tag36h11"
[[tags]]
id = 0
size_mm = {size_mm}
position_mm = [0, 0, 0]
rotation_rad = [0, 0, 0]
"""


def turn() -> np.ndarray:
    """Reference from target: 0.3 rad about y after 0.2 rad about z."""
    cy, sy, cz, sz = np.cos(0.3), np.sin(0.3), np.cos(0.2), np.sin(0.2)
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    product: np.ndarray = about_y @ about_z
    return product


def drawn(lens_x_mm: float) -> np.ndarray:
    """The luma that a camera sees whose lens centre lies there, looking along z: each pixel the mean of its area."""
    cells = np.full((10, 10), 200.0)
    cells[1:9, 1:9] = 30.0
    cells[2:8, 2:8] += 170.0 * np.array([CODE >> (35 - bit) & 1 for bit in range(36)]).reshape(6, 6)
    camera = np.array([[FOCAL_PX, 0, CENTRE_PX[0]], [0, FOCAL_PX, CENTRE_PX[1]], [0, 0, 1]])
    centre_mm = PLACE_MM - np.array([lens_x_mm, 0, 0])
    pixels_from_cells = camera @ np.column_stack([turn()[:, 0] * SIZE_MM / 8, turn()[:, 1] * SIZE_MM / 8, centre_mm])
    offsets = (np.arange(SAMPLES) + 0.5) / SAMPLES - 0.5
    left_px, top_px = (CENTRE_PX + FOCAL_PX * centre_mm[:2] / centre_mm[2]).astype(int) - WINDOW_PX // 2
    u = (left_px + np.arange(WINDOW_PX)[:, None] + offsets).ravel()
    v = (top_px + np.arange(WINDOW_PX)[:, None] + offsets).ravel()
    places = np.linalg.inv(pixels_from_cells) @ np.stack([*np.meshgrid(u, v), np.ones((v.size, u.size))]).reshape(3, -1)
    column, row = (np.floor(places[axis] / places[2] + 5.0).astype(int) for axis in (0, 1))
    inside = (column >= 0) & (column < 10) & (row >= 0) & (row < 10)
    values = np.where(inside, cells[np.clip(row, 0, 9), np.clip(column, 0, 9)], 120.0)
    luma = np.full((480, 640), 120.0)
    means = values.reshape(WINDOW_PX, SAMPLES, WINDOW_PX, SAMPLES).mean(axis=(1, 3))
    luma[top_px : top_px + WINDOW_PX, left_px : left_px + WINDOW_PX] = means
    return luma


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three pairs of grey pictures, each with noise of its own."""
    folder = tmp_path_factory.mktemp("tags")
    random = np.random.default_rng(3)
    rows = ["camera,index,exposure_mid_ns,arrival_ns"]
    for side, lens_x_mm in (("left", -BASELINE_MM / 2), ("right", BASELINE_MM / 2)):
        (folder / side).mkdir()
        luma = drawn(lens_x_mm)
        for index in range(3):
            noisy = np.clip(np.rint(luma + random.normal(0.0, 1.0, luma.shape)), 0, 255).astype(np.uint8)
            (folder / side / f"{index:08d}.png").write_bytes(png(640, 480, noisy.tobytes(), grey=True))
    for index in range(3):
        rows += [f"{side},{index},{index * FRAME_NS},{index * FRAME_NS}" for side in ("left", "right")]
    (folder / "frames.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    (folder / "recording.toml").write_text(
        'format = "tripoint-recording/1"\npixel_format = "png"\nwidth_px = 640\nheight_px = 480\n', encoding="utf-8"
    )
    (folder / "calibration.toml").write_text(CALIBRATION, encoding="utf-8")
    return folder


def replayed(recording: Path, size_mm: float) -> list[dict[str, Any]]:
    target = recording / "target.toml"
    target.write_text(TARGET.format(size_mm=size_mm), encoding="utf-8")
    files = ["--calibration", str(recording / "calibration.toml"), "--target", str(target)]
    run = finished("replay", str(recording), *files, "--json")
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


def test_a_tag_in_grey_pictures_gives_the_pose_with_which_it_was_drawn(recording: Path) -> None:
    first, *others = replayed(recording, SIZE_MM)
    assert first["faults"] == ["timing_bound"], "one pair says nothing about the cameras' clocks"
    assert len(others) == 2
    for verdict in others:
        assert (verdict["valid"], verdict["orientation_valid"]) == (True, True), verdict["faults"]
        assert np.allclose(verdict["position_mm"], PLACE_MM, atol=0.2)  # 0.03 px in depth, at 410 mm
        w, x, y, z = np.array(verdict["quaternion_wxyz"])
        axes = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z)], [2 * (x * y + w * z), 1 - 2 * (x * x + z * z)]]
        assert np.allclose(axes, turn()[:2, :2], atol=3e-3)
        (point,) = verdict["points"]
        assert point["id"] == 0
        assert np.allclose(point["position_mm"], PLACE_MM, atol=0.2)


def test_a_tag_of_another_size_than_the_target_says_is_refused(recording: Path) -> None:
    for verdict in replayed(recording, 1.03 * SIZE_MM):
        assert verdict["valid"] is False


def test_a_target_of_leds_is_no_target_for_tags() -> None:
    refused = finished("check-config", str(CONFIG), "--set", "detector.kind=apriltag")
    assert refused.returncode == 2
    assert "target.file" in refused.stderr
    assert "the target is made of LEDs" in refused.stderr
