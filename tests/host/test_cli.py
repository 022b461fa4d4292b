"""The commands as a user sees them: what goes to stdout and stderr, and the exit code."""

import itertools
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from host.fake_unit import FakeUnit, Manner, fake_unit
from host.register_image import UTC_NS, measuring_image

from host_tool.cli import status as status_command
from host_tool.cli.main import run
from host_tool.cli.views import PlainLines
from host_tool.errors import ExitCode
from host_tool.trajectories.paths import SCENARIOS

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def unit() -> Iterator[FakeUnit]:
    """Brings a new verdict with every request."""
    sequence = itertools.count(70000)
    with fake_unit(lambda: measuring_image(next(sequence))) as fake:
        yield fake


def output_of(capture: Capture, *arguments: str, code: int = ExitCode.PASS) -> tuple[str, str]:
    assert run(arguments) == code
    captured = capture.readouterr()
    return captured.out, captured.err


def json_of(capture: Capture, *arguments: str, code: int = ExitCode.PASS) -> Any:
    return json.loads(output_of(capture, *arguments, "--json", code=code)[0])


def test_status_names_unit_state_and_remedies(unit: FakeUnit, capsys: Capture) -> None:
    out, err = output_of(capsys, "status", "--device", unit.device)
    assert err == ""
    for text in (
        "serial 4711, firmware 0.2.9",
        "led position, SIMULATED",
        "measuring\n",
        "for 3600 s",
        "p99 980 us",
        "43981 (0xABCD), register 146",
        "3405643777 (0xCAFE0001)",
        "LED 2.1x above dim, 12x below clipping\n",
    ):
        assert text in out
    assert "refused clients: check the limits and the allow-list in [modbus]" in out


@pytest.mark.parametrize(("status", "words"), [(0x0447, "no datum is"), (0x4447, "a datum is")])
def test_status_says_whether_a_datum_watches_the_mount(status: int, words: str, capsys: Capture) -> None:
    with fake_unit(lambda: measuring_image(status=status)) as real:
        out, _ = output_of(capsys, "status", "--device", real.device)
    [mount] = [line for line in out.splitlines() if line.startswith("mount")]
    assert mount.endswith(f"{words} seen where it belongs")


def test_status_speaks_json(unit: FakeUnit, capsys: Capture) -> None:
    record = json_of(capsys, "status", "--device", unit.device)
    assert record["pose"]["position_mm"] == [-12.345, 6.789, 400.001]
    assert record["warnings"][0]["name"] == "refused_clients"
    assert record["cameras"]["right"]["temperature_c"] == 41.5
    assert record["cameras"]["left"]["below_clipping"] == 11.8


def test_watch_prints_a_line_for_each_verdict(unit: FakeUnit, capsys: Capture) -> None:
    out, _ = output_of(capsys, "watch", "--count", "3", "--device", unit.device)
    lines = out.splitlines()
    assert len(lines) == 3
    assert "-12.345 ±0.120" in lines[0]
    assert "age 23.5 ms" in lines[0]
    assert "\x1b" not in out


def test_watch_compares_with_a_truth_file(unit: FakeUnit, capsys: Capture, tmp_path: Path) -> None:
    file = tmp_path / "rest.csv"
    rows = ("t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz", "0,-12.345,6.789,400.301,0,1,0,0", "1,-12.345,6.789,400.301,0,1,0,0")
    file.write_text("\n".join(rows), encoding="utf-8")
    record = json_of(capsys, "watch", "--count", "1", "--truth", str(file), "--device", unit.device)
    assert record["error_mm"] == pytest.approx(0.3)
    assert record["inside"] is True


def test_watch_knows_the_truth_of_a_scenario_at_the_time_of_exposure(unit: FakeUnit, capsys: Capture) -> None:
    record = json_of(capsys, "watch", "--count", "1", "--truth", "paper-circular", "--device", unit.device)
    assert record["truth_mm"] == pytest.approx(list(SCENARIOS["paper-circular"].position_at_utc_mm(UTC_NS)))


def test_watch_tells_the_margin_of_the_exposure(unit: FakeUnit, capsys: Capture) -> None:
    record = json_of(capsys, "watch", "--count", "1", "--device", unit.device)
    assert record["exposure"]["right"] == {"above_dim": 2.1, "below_clipping": 11.8}


def test_watch_refuses_to_compare_real_cameras_with_a_scenario(capsys: Capture, tmp_path: Path) -> None:
    with fake_unit(lambda: measuring_image(status=0x0447)) as real:
        arguments = ("watch", "--count", "1", "--device", real.device)
        out, err = output_of(capsys, *arguments, "--truth", "scout", code=ExitCode.USAGE)
        assert out == ""
        assert err.startswith("E-USE-07 this unit measures real cameras")
        file = tmp_path / "there.csv"
        output_of(capsys, "simulate", "static-volume", "--out", str(file))
        out, _ = output_of(capsys, *arguments, "--truth", str(file))  # a place that was measured is a truth
    assert "error" in out


@pytest.mark.parametrize(("limits", "code"), [((), ExitCode.PASS), (("--count", "9"), ExitCode.INTERRUPTED)])
def test_ctrl_c_ends_well_a_watch_that_has_no_other_end(
    limits: tuple[str, ...], code: int, unit: FakeUnit, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    def press_ctrl_c(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(PlainLines, "show", press_ctrl_c)
    output_of(capsys, "watch", *limits, "--device", unit.device, code=code)


def test_watch_ends_after_its_seconds(capsys: Capture) -> None:
    with fake_unit(measuring_image) as silent:
        out, _ = output_of(capsys, "watch", "--seconds", "0.7", "--device", silent.device)
    assert "NOTHING NEW" in out.splitlines()[-1]


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ((), ExitCode.PASS),
        (("--word-order", "abcd", "--table", "input"), ExitCode.PASS),
        (("--word-order", "cdab", "--base", "2000"), ExitCode.PASS),
        (("--word-order", "cdab"), ExitCode.FAILED),
        (("--offset", "1"), ExitCode.FAILED),
    ],
)
def test_probe_fails_exactly_for_a_setting_that_reads_wrong(
    options: tuple[str, ...], code: int, unit: FakeUnit, capsys: Capture
) -> None:
    record = json_of(capsys, "plc", "probe", *options, "--device", unit.device, code=code)
    assert record["right"] is (None if not options else code == ExitCode.PASS)


def test_probe_says_what_would_be_read_and_what_to_change(unit: FakeUnit, capsys: Capture) -> None:
    out, _ = output_of(capsys, "plc", "probe", "--word-order", "cdab", "--device", unit.device, code=ExitCode.FAILED)
    (mine,) = [line for line in out.splitlines() if line.endswith("<- yours")]
    assert "0x03040102" in mine
    assert "To change: set the client's word order to abcd or add 2000 to every address." in out


def test_simulate_writes_to_stdout_or_a_file(capsys: Capture, tmp_path: Path) -> None:
    file = tmp_path / "line.csv"
    out, _ = output_of(capsys, "simulate", "paper-linear", "--rate", "10")
    output_of(capsys, "simulate", "paper-linear", "--rate", "10", "--out", str(file))
    assert file.read_text(encoding="utf-8") == out
    assert len(out.splitlines()) == 122


def test_simulate_says_when_it_cannot_write(capsys: Capture, tmp_path: Path) -> None:
    target = str(tmp_path / "none" / "line.csv")
    _, err = output_of(capsys, "simulate", "paper-linear", "--out", target, code=ExitCode.USAGE)
    assert err.startswith("E-TRJ-06")


def test_demo_of_a_unit_that_is_elsewhere_than_the_truth_fails(unit: FakeUnit, capsys: Capture) -> None:
    arguments = ("demo", "--seconds", "5.8", "--device", unit.device)
    out, err = output_of(capsys, *arguments, code=ExitCode.FAILED)
    assert "inside k = 2     0.0 % on all three axes" in out
    assert "verdict          failed: 0.0% of the poses inside k = 2" in out
    assert err == ""


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("nonsense",), ExitCode.USAGE),
        (("watch", "--count", "0"), ExitCode.USAGE),
        (("status", "--device", "unit:port"), ExitCode.USAGE),
        (("watch", "--truth", "/none.csv"), ExitCode.USAGE),
        (("status", "--device", "127.0.0.1:1", "--timeout", "0.2"), ExitCode.NO_DEVICE),
        (("--help",), ExitCode.PASS),
        (("--version",), ExitCode.PASS),
    ],
)
def test_exit_codes_are_as_documented(arguments: tuple[str, ...], code: int, capsys: Capture) -> None:
    out, err = output_of(capsys, *arguments, code=code)
    assert bool(err) is (code != ExitCode.PASS)
    assert bool(out) is (code == ExitCode.PASS)


def test_a_unit_that_falls_silent_ends_with_a_code_and_a_remedy(capsys: Capture) -> None:
    with fake_unit(measuring_image, Manner.SILENT) as silent:
        arguments = ("status", "--device", silent.device, "--timeout", "0.2")
        _, err = output_of(capsys, *arguments, code=ExitCode.NO_DEVICE)
    assert err.startswith("E-NET-02 ")
    assert "longer --timeout" in err


@pytest.mark.parametrize(
    ("raised", "code", "text"),
    [
        (KeyboardInterrupt(), ExitCode.INTERRUPTED, "interrupted"),
        (RuntimeError("surprise"), ExitCode.OUR_FAULT, "E-BUG-01 RuntimeError (surprise)"),
    ],
)
def test_a_user_never_sees_a_traceback(
    raised: BaseException, code: int, text: str, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    def fail(*_: object) -> None:
        raise raised

    monkeypatch.delenv("HOST_TOOL_DEBUG", raising=False)
    monkeypatch.setattr(status_command, "open_unit", fail)
    out, err = output_of(capsys, "status", code=code)
    assert out == ""
    assert text in err
    assert "Traceback" not in err
