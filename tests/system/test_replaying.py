"""`tripointd replay` on recordings of which some or all frames are of no use."""

from pathlib import Path

from system.daemon import CONFIG, finished

WIDTH_PX, HEIGHT_PX = 640, 480  # as the demo's calibration has it
WHOLE = WIDTH_PX * HEIGHT_PX * 2
FRAME_NS = 33_333_333
CALIBRATION = CONFIG.parent / "calibration.toml"


def recording(folder: Path, pixel_format: str, pictures: list[bytes], more: str = "") -> Path:
    """Pictures of the left camera; each is what its file holds."""
    (folder / "left").mkdir(parents=True)
    rows = ["camera,index,exposure_mid_ns,arrival_ns"]
    for index, picture in enumerate(pictures):
        (folder / f"left/{index:08d}.{pixel_format}").write_bytes(picture)
        rows.append(f"left,{index},{index * FRAME_NS},{index * FRAME_NS}")
    (folder / "frames.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    description = ['format = "tripoint-recording/1"', f'pixel_format = "{pixel_format}"', f"width_px = {WIDTH_PX}"]
    text = "\n".join([*description, f"height_px = {HEIGHT_PX}", more])
    (folder / "recording.toml").write_text(text, encoding="utf-8")
    return folder


def replayed(folder: Path) -> tuple[int, list[str]]:
    """The exit code, and the lines of stderr."""
    run = finished("replay", str(folder), "--calibration", str(CALIBRATION), "--json")
    return run.returncode, run.stderr.splitlines()


def test_the_first_unusable_frame_is_named_and_the_rest_counted(tmp_path: Path) -> None:
    dark, short = bytes(WHOLE), bytes(WHOLE - 1)
    code, said = replayed(recording(tmp_path / "some", "yuyv", [dark, short, dark, short, dark]))
    assert code == 0
    assert len(said) == 2
    assert "left/00000001.yuyv" in said[0]
    assert "2 of 5 frames" in said[1]


def test_a_recording_without_any_usable_frame_is_an_error(tmp_path: Path) -> None:
    folder = recording(tmp_path / "none", "jpg", [b"no picture"] * 3)
    code, said = replayed(folder)
    assert code == 2
    assert len(said) == 2
    assert "left/00000000.jpg: JPEG not usable" in said[0]
    assert str(folder) in said[1]
    assert "none of its 3 frames" in said[1]


def test_spheres_are_not_measured(tmp_path: Path) -> None:
    folder = recording(tmp_path / "dark", "yuyv", [bytes(WHOLE)])
    config = tmp_path / "unit.toml"
    config.write_text(CONFIG.read_text(encoding="utf-8") + '[detector]\nkind = "sphere"\n', encoding="utf-8")
    run = finished("replay", str(folder), "--calibration", str(CALIBRATION), "--config", str(config), "--json")
    assert run.returncode == 2
    assert run.stdout == ""
    assert "detector.kind" in run.stderr
    assert 'set "led"' in run.stderr


def test_a_modulated_configuration_is_refused(tmp_path: Path) -> None:
    config = tmp_path / "modulated.toml"
    text = CONFIG.read_text(encoding="utf-8") + "[modulation]\nenabled = true\n"
    config.write_text(text, encoding="utf-8")
    folder = recording(tmp_path / "r", "yuyv", [bytes(WHOLE)])
    run = finished("replay", str(folder), "--calibration", str(CALIBRATION), "--config", str(config))
    assert run.returncode != 0
    assert "modulation.enabled: a recording does not say which LEDs were lit when" in run.stderr
    assert "set false" in run.stderr


def test_an_unknown_key_is_named_with_its_line(tmp_path: Path) -> None:
    code, said = replayed(recording(tmp_path / "newer", "yuyv", [bytes(WHOLE)], "line_time_ms = 1"))
    assert code == 2
    assert "recording.toml:5" in said[0]
    assert "line_time_ms" in said[0]
