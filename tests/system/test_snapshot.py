"""tripointd snapshot on simulated cameras: pictures of a board as calibrating wants them, or the reason why not."""

import json
import re
import struct
import subprocess
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from system.daemon import CONFIG, binary, finished

LIMIT_S = 60.0
WELL, USAGE, MISSING = 0, 2, 3
EXPOSURE_US = 32_000
WHITE, BLACK = 0.64, 0.032  # of clip: paper reflects 80 %, toner 4 %, of a light that is 5 % of clip in 2000 us


@pytest.fixture
def config(tmp_path: Path) -> Path:
    """The demo's configuration with an exposure for calibrating."""
    binary()  # skips where there is none
    for file in CONFIG.parent.glob("*.toml"):
        (tmp_path / file.name).symlink_to(file)
    copy = tmp_path / "unit.toml"
    text = CONFIG.read_text(encoding="utf-8") + f"\n[cameras.calibrating]\nexposure_us = {EXPOSURE_US}\n"
    copy.write_text(text, encoding="utf-8")
    return copy


def taken(config: Path, out: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return finished("snapshot", "--config", str(config), "--out", str(out), *arguments, limit_s=LIMIT_S)


def line_of(config: Path, out: Path, *arguments: str) -> Any:
    """The JSON line of one snapshot."""
    done = taken(config, out, "--json", *arguments)
    assert done.returncode == WELL, done.stderr
    return json.loads(done.stdout)


def row_of(filtered: bytes, kind: int, above: npt.NDArray[np.int64], step: int) -> npt.NDArray[np.int64]:
    """Undoes the filter of one row of a PNG file (PNG specification, clause 9)."""
    row = np.frombuffer(filtered, dtype=np.uint8).astype(np.int64)
    for i in range(len(row)):
        left, up, corner = (row[i - step] if i >= step else 0), above[i], (above[i - step] if i >= step else 0)
        nearest = min(
            (abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner)
        )[2]
        row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[kind]) % 256
    return row


def luma_of(path: Path) -> npt.NDArray[np.int64]:
    """Rows of the first channel of an RGB file; the others are the same: grey."""
    data = path.read_bytes()
    width_px, height_px = struct.unpack(">II", data[16:24])
    assert data[24:26] == b"\x08\x02"  # 8 bit, RGB
    packed, place = b"", 8
    while place < len(data):
        (length,) = struct.unpack(">I", data[place : place + 4])
        packed += data[place + 8 : place + 8 + length] if data[place + 4 : place + 8] == b"IDAT" else b""
        place += length + 12
    rows, stride = zlib.decompress(packed), 3 * width_px + 1
    above, luma = np.zeros(3 * width_px, dtype=np.int64), np.zeros((height_px, width_px), dtype=np.int64)
    for y in range(height_px):
        above = row_of(rows[y * stride + 1 : (y + 1) * stride], rows[y * stride], above, 3)
        assert (above[0::3] == above[1::3]).all()
        luma[y] = above[0::3]
    return luma


@pytest.mark.parametrize(("format_", "offset", "span"), [("yuyv", 16, 219), ("mjpeg", 0, 255)])
def test_both_pictures_show_the_board_with_the_white_of_the_exposure(
    config: Path, tmp_path: Path, format_: str, offset: int, span: int
) -> None:
    """22 % of the picture are white paper, 14 % black: a tenth and 7 % lie in the middle of each."""
    small = ["cameras.width_px=320", "cameras.height_px=240", f"cameras.format={format_}"]
    line = line_of(config, tmp_path / "board", *(argument for setting in small for argument in ("--set", setting)))
    assert (line["exposure_us"], line["gain"]) == (EXPOSURE_US, 0)
    for side in ("left", "right"):
        luma = luma_of(Path(line[side]["file"]))
        assert luma.shape == (240, 320)
        assert np.quantile(luma, 0.90) == pytest.approx(offset + span * WHITE, abs=3.0)
        assert np.quantile(luma, 0.07) == pytest.approx(offset + span * BLACK, abs=3.0)
        assert line[side]["white"] == pytest.approx(
            (offset + span * WHITE - 16) / 219, abs=0.02
        )  # small squares, much edge


def test_a_pair_has_one_stamp_and_every_pair_its_own(config: Path, tmp_path: Path) -> None:
    out = tmp_path / "not" / "yet"
    lines = [line_of(config, out), line_of(config, out)]
    names = sorted(path.name for path in out.iterdir())
    assert len(names) == 4
    stamps = [re.fullmatch(r"(left|right)-(\d{8}T\d{6}\.\d{3}Z)\.png", name) for name in names]
    assert all(stamps)
    assert {Path(line[side]["file"]).name for line in lines for side in ("left", "right")} == set(names)
    for line in lines:
        left, right = (Path(line[side]["file"]).name.partition("-")[2] for side in ("left", "right"))
        assert left == right
        apart_ns = line["right"]["exposed_ns"] - line["left"]["exposed_ns"]
        assert 0 < apart_ns <= 2e9 / 30.0


def test_a_picture_without_a_board_is_taken_and_says_so(config: Path, tmp_path: Path) -> None:
    dark = ("--set", "simulation.white_level=0")
    assert line_of(config, tmp_path / "dark", *dark)["left"]["white"] is None
    done = taken(config, tmp_path / "dark", *dark)
    assert done.returncode == WELL
    assert done.stdout.count("no board is seen") == 2


def test_without_an_exposure_for_calibrating_it_says_what_finds_one(config: Path, tmp_path: Path) -> None:
    config.write_text(CONFIG.read_text(encoding="utf-8"), encoding="utf-8")
    done = taken(config, tmp_path / "board")
    assert done.returncode == USAGE
    assert f"`tripointd expose --config {config} --for calibrating --write` finds it" in done.stderr
    assert not (tmp_path / "board").exists()
    assert (
        finished("expose", "--config", str(config), "--for", "calibrating", "--write", limit_s=LIMIT_S).returncode
        == WELL
    )
    assert taken(config, tmp_path / "board").returncode == WELL


def test_a_folder_that_cannot_be_made_is_named(config: Path) -> None:
    done = taken(config, config / "board")
    assert done.returncode == USAGE
    assert f"{config / 'board'}: " in done.stderr


def test_a_missing_camera_is_named(config: Path, tmp_path: Path) -> None:
    done = taken(
        config,
        tmp_path / "board",
        "--set",
        "cameras.source=v4l2",
        "--set",
        "cameras.left.serial=none",
        "--set",
        "cameras.right.port=9-9",
    )
    assert done.returncode == MISSING
    assert "camera left" in done.stderr
    assert not list((tmp_path / "board").iterdir())


def test_a_recording_has_its_pictures(config: Path, tmp_path: Path) -> None:
    done = taken(config, tmp_path, "--set", "cameras.source=recording", "--set", f"recording.folder={tmp_path}")
    assert done.returncode == USAGE
    assert "recording" in done.stderr
