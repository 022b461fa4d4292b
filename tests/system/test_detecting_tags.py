"""`tripointd detect --detector apriltag`: a drawn tag, and what is said when there is nothing to be done."""

import json
from pathlib import Path

import numpy as np
from system.daemon import finished
from system.pictures import png

CODE = 0xD5D628584  # id 0 of tag36h11 as published with AprilTag 2: 36 bits row by row, 1 is light
CELL_PX = 9
LEFT_PX, TOP_PX = 60, 40  # of the dark square, a whole pixel


def tag(path: Path) -> Path:
    """The tag upright, its cells of whole pixels, on a light ground."""
    square = np.zeros((8, 8), np.uint8)
    square[1:7, 1:7] = np.array([CODE >> (35 - bit) & 1 for bit in range(36)], np.uint8).reshape(6, 6)
    image = np.full((160, 200), 220, np.uint8)
    pixels = np.kron(square, np.full((CELL_PX, CELL_PX), 180, np.uint8)) + 40
    image[TOP_PX : TOP_PX + 8 * CELL_PX, LEFT_PX : LEFT_PX + 8 * CELL_PX] = pixels
    path.write_bytes(png(200, 160, image.tobytes(), grey=True))
    return path


def test_a_tag_in_a_grey_picture_is_told_by_id_corners_and_centre(tmp_path: Path) -> None:
    run = finished("detect", str(tag(tmp_path / "tag.png")), "--detector", "apriltag", "--json")
    assert run.returncode == 0, run.stderr
    line = json.loads(run.stdout)
    assert list(line) == ["image", "looked_at", "cut", "points", "dropped"]
    (point,) = line["points"]
    left, top = LEFT_PX - 0.5, TOP_PX - 0.5  # pixel centres at integers
    right, bottom = left + 8 * CELL_PX, top + 8 * CELL_PX
    assert point["id"] == 0
    assert np.allclose(point["corners_px"], [[left, bottom], [right, bottom], [right, top], [left, top]], atol=0.02)
    assert np.allclose([point["u_px"], point["v_px"]], [(left + right) / 2, (top + bottom) / 2], atol=0.02)
    assert (point["rough"], point["corrected_bits"], point["saturated"], round(point["peak"])) == (None, 0, False, 220)


def test_a_tag_of_another_family_is_not_found(tmp_path: Path) -> None:
    run = finished("detect", str(tag(tmp_path / "tag.png")), "--detector", "apriltag", "--family", "tag25h9", "--json")
    assert run.returncode == 0, run.stderr
    assert json.loads(run.stdout)["points"] == []


def test_the_tag_is_explained_in_an_image(tmp_path: Path) -> None:
    image, why = tag(tmp_path / "tag.png"), tmp_path / "why"
    run = finished("detect", str(image), "--detector", "apriltag", "--json", "--explain", str(why))
    assert run.returncode == 0, run.stderr
    line = json.loads(run.stdout)
    assert line["explanation"] == str(why / "tag.explain.png")
    assert (why / "tag.explain.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def test_a_folder_that_cannot_be_made_is_said(tmp_path: Path) -> None:
    image = tag(tmp_path / "tag.png")
    run = finished("detect", str(image), "--detector", "apriltag", "--explain", str(image))
    assert run.returncode == 2
    assert run.stdout == ""
    assert str(image) in run.stderr


def test_a_family_that_is_none_is_said(tmp_path: Path) -> None:
    run = finished("detect", str(tag(tmp_path / "tag.png")), "--detector", "apriltag", "--family", "tag99")
    assert run.returncode == 2
    assert run.stdout == ""
    assert "--family" in run.stderr
    assert "tagStandard41h12" in run.stderr
