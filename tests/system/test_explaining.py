"""`tripointd detect --explain FOLDER`: which files it writes, what it says, and what it never touches."""

import json
import struct
import subprocess
from pathlib import Path
from typing import Any

import pytest
from system.daemon import CONFIG, finished
from system.pictures import png

LIMIT_S = 60.0
RED, DARK = (255, 40, 25), (8, 8, 8)


def lights(path: Path, size_px: tuple[int, int], places: list[tuple[int, int]]) -> Path:
    """Red Gaussian spots of sigma 2 px on a dark ground; LEDs as the detector should find them."""
    width_px, height_px = size_px
    rgb = bytearray(bytes(DARK) * (width_px * height_px))
    for at_x, at_y in places:
        for y in range(max(0, at_y - 8), min(height_px, at_y + 9)):
            for x in range(max(0, at_x - 8), min(width_px, at_x + 9)):
                share = 2.0 ** (-((x - at_x) ** 2 + (y - at_y) ** 2) / 5.5)
                for channel in range(3):
                    index = 3 * (y * width_px + x) + channel
                    level = DARK[channel] + share * (RED[channel] - DARK[channel])
                    rgb[index] = max(rgb[index], round(level))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(png(width_px, height_px, bytes(rgb)))
    return path


def explained(folder: Path, *images: Path) -> tuple[subprocess.CompletedProcess[str], list[dict[str, Any]]]:
    """The run, and its lines."""
    run = finished("detect", *map(str, images), "--explain", str(folder), "--json", limit_s=LIMIT_S)
    return run, [json.loads(line) for line in run.stdout.splitlines()]


def size_of(path: Path) -> tuple[int, int]:
    """Width and height of a whole PNG file."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert data[-8:-4] == b"IEND"
    width_px, height_px = struct.unpack(">II", data[16:24])
    return width_px, height_px


def test_every_candidate_is_told_and_the_file_named(tmp_path: Path) -> None:
    image = lights(tmp_path / "in/a.png", (320, 240), [(100, 80), (200, 150)])
    run, (line,) = explained(tmp_path / "new/why", image)
    assert run.returncode == 0, run.stderr
    assert line["explanation"] == str(tmp_path / "new/why/a.explain.png")
    assert size_of(Path(line["explanation"]))[0] > 1280
    kept = [candidate for candidate in line["candidates"] if candidate["cause"] == "kept"]
    assert [(round(c["u_px"]), round(c["v_px"])) for c in kept] == [(100, 80), (200, 150)]
    assert [point["u_px"] for point in line["points"]] == [candidate["u_px"] for candidate in kept]
    assert [candidate["number"] for candidate in line["candidates"]] == list(range(1, len(line["candidates"]) + 1))
    assert all(candidate["why"] for candidate in line["candidates"])


def ball(path: Path, at_px: tuple[int, int], radius_px: int) -> Path:
    """A red disc on a dark ground."""
    rgb = b"".join(
        bytes((190, 50, 50) if (x - at_px[0]) ** 2 + (y - at_px[1]) ** 2 <= radius_px**2 else DARK)
        for y in range(240)
        for x in range(320)
    )
    path.write_bytes(png(320, 240, rgb))
    return path


def test_the_settings_for_spheres_find_a_ball_and_no_light(tmp_path: Path) -> None:
    settings = CONFIG.parents[1] / "settings/passive_spheres.toml"
    images = [ball(tmp_path / "ball.png", (150, 110), 30), lights(tmp_path / "led.png", (320, 240), [(100, 80)])]
    why = tmp_path / "why"
    run = finished("detect", *map(str, images), "--config", str(settings), "--explain", str(why), "--json")
    assert run.returncode == 0, run.stderr
    of_ball, of_led = map(json.loads, run.stdout.splitlines())
    assert [(round(p["u_px"]), round(p["v_px"])) for p in of_ball["points"]] == [(150, 110)]
    assert [candidate["cause"] for candidate in of_ball["candidates"]] == ["kept"]
    assert of_ball["candidates"][0]["why"].startswith("radius 30")
    assert of_led["points"] == []
    assert size_of(Path(of_ball["explanation"]))


@pytest.mark.parametrize(("detector", "found"), [("led", 0), ("sphere", 1)])
def test_the_detector_is_the_one_that_is_asked_for(tmp_path: Path, detector: str, found: int) -> None:
    settings = CONFIG.parents[1] / "settings/passive_spheres.toml"
    image = ball(tmp_path / "ball.png", (150, 110), 30)
    for configured in ([], ["--config", str(settings)]):
        run = finished("detect", str(image), "--detector", detector, *configured, "--json")
        assert run.returncode == 0, run.stderr
        assert len(json.loads(run.stdout)["points"]) == found


def test_without_it_the_line_has_no_more_fields(tmp_path: Path) -> None:
    image = lights(tmp_path / "a.png", (320, 240), [(100, 80)])
    (line,) = map(json.loads, finished("detect", str(image), "--json").stdout.splitlines())
    assert list(line) == ["image", "looked_at", "cut", "points"]
    assert (line["looked_at"], line["cut"]) == (True, False)


def test_pictures_of_one_name_from_two_folders_get_two_files(tmp_path: Path) -> None:
    images = [lights(tmp_path / side / "00000001.png", (64, 48), []) for side in ("left", "right")]
    run, lines = explained(tmp_path / "why", *images)
    assert run.returncode == 0
    written = [Path(line["explanation"]) for line in lines]
    assert [path.name for path in written] == ["00000001.explain.png", "00000001-2.explain.png"]
    assert all(path.is_file() for path in written)


def test_an_input_is_never_written_over(tmp_path: Path) -> None:
    first = lights(tmp_path / "a.png", (64, 48), [])
    second = lights(tmp_path / "a.explain.png", (64, 48), [(30, 20)])
    before = second.read_bytes()
    run, lines = explained(tmp_path, first, second)
    assert run.returncode == 0
    assert second.read_bytes() == before
    assert [Path(line["explanation"]).name for line in lines] == ["a-2.explain.png", "a.explain.explain.png"]


@pytest.mark.parametrize("below", ["", "below"])
def test_a_file_in_the_place_of_the_folder_is_refused_before_anything_is_read(tmp_path: Path, below: str) -> None:
    image = lights(tmp_path / "a.png", (64, 48), [])
    run, lines = explained(image / below, image)
    assert run.returncode == 2
    assert lines == []
    assert run.stderr.startswith(f"tripointd: {image}")
    assert run.stderr.count("\n") == 1


def test_an_explanation_that_cannot_be_written_is_said_and_the_rest_goes_on(tmp_path: Path) -> None:
    images = [lights(tmp_path / name, (64, 48), []) for name in ("a.png", "b.png")]
    (tmp_path / "why/a.explain.png").mkdir(parents=True)
    run, lines = explained(tmp_path / "why", *images)
    assert run.returncode == 2
    assert run.stderr.startswith(f"tripointd: {tmp_path / 'why/a.explain.png'}: cannot")
    assert "explanation" not in lines[0]
    assert lines[0]["points"] == []
    assert size_of(Path(lines[1]["explanation"]))


def test_an_unreadable_picture_has_no_explanation_and_the_rest_goes_on(tmp_path: Path) -> None:
    broken = tmp_path / "broken.jpg"
    broken.write_bytes(b"\xff\xd8 no picture")
    run, lines = explained(tmp_path / "why", broken, tmp_path / "none.png", lights(tmp_path / "a.png", (64, 48), []))
    assert run.returncode == 2
    assert ["error" in line for line in lines] == [True, True, False]
    assert [path.name for path in (tmp_path / "why").iterdir()] == ["a.explain.png"]


def test_a_grey_picture_is_explained_too(tmp_path: Path) -> None:
    image = tmp_path / "grey.png"
    image.write_bytes(png(64, 48, bytes(range(48)) * 64, grey=True))
    run, (line,) = explained(tmp_path / "why", image)
    assert run.returncode == 0
    assert line["looked_at"] is False
    assert line["cut"] is False
    assert line["points"] == []
    assert line["candidates"] == []
    assert size_of(Path(line["explanation"]))


def test_a_huge_picture_with_500_spots_and_some_at_the_border_stays_readable(tmp_path: Path) -> None:
    places = [(x, y) for y in range(0, 2160, 106) for x in range(0, 3840, 160)]
    image = lights(tmp_path / "huge.png", (3840, 2160), places)
    run, (line,) = explained(tmp_path / "why", image)
    assert run.returncode == 0, run.stderr
    assert len(places) >= 500
    assert len(line["candidates"]) <= 256
    assert line["cut"] is True
    assert len(line["points"]) < len(places)
    width_px, height_px = size_of(Path(line["explanation"]))
    assert width_px == 1920 + 40
    assert height_px < 3000
