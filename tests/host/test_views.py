"""What is drawn in a terminal, and where nothing is redrawn."""

import io
from dataclasses import replace

import pytest
from host.staged import HEALTH, POSE, answer
from rich.console import Console

from host_tool.cli.views import BARS, JsonLines, Picture, PlainLines, picture_of, sparkline, view_for
from host_tool.contract.blocks import Identity, Pose
from host_tool.contract.conditions import Status
from host_tool.watching.follow import Sighting
from host_tool.watching.session import Scene
from host_tool.watching.tally import Tally
from host_tool.watching.truth import Comparison

IDENTITY = Identity(1, 0, 4711, "0.1.0", "led_position", 1, 1, "reference")


def scene(pose: Pose = POSE, at_s: float = 0.0, fresh: bool = True) -> Scene:
    comparison = Comparison((0.05, 0.0, 400.0), 0.05, inside=True) if pose.position_valid else None
    return Scene(
        Sighting(answer(pose), at_s, fresh, 0),
        comparison,
        26.2,
        None if pose.position_valid else 3.2,
        Tally().summary(),
        HEALTH,
    )


def drawn(a_scene: Scene) -> str:
    console = Console(file=io.StringIO(), width=100, record=True)
    console.print(picture_of(a_scene, "Tripoint 4711", (0.05, 0.1)))
    return console.export_text()


def test_the_picture_shows_measured_against_truth() -> None:
    text = drawn(scene())
    for part in ("Tripoint 4711", "SIMULATED", "400.000", "-0.050", "26 mm/s", "age 20.0 ms", "max 0.1 mm"):
        assert part in text


def test_the_picture_shows_how_the_target_is_turned() -> None:
    turned = replace(
        POSE,
        status=POSE.status | Status.ORIENTATION_VALID,
        angles_deg=(0.25, -1.5, 179.9),
        quaternion_wxyz=(0.0, 1.0, 0.0, 0.0),
        uncertainty_deg=(0.11, 0.72, 0.81),
    )
    text = drawn(replace(scene(turned), comparison=Comparison((0.05, 0.0, 400.0), 0.05, True, turned_deg=0.042)))
    for part in ("A deg", "0.250", "-1.500", "179.900", "0.810", "turned by 0.042 degrees from the truth"):
        assert part in text


def test_the_picture_says_why_there_is_no_position() -> None:
    text = drawn(scene(replace(POSE, status=0, faults=1 << 8)))
    assert "no valid position for 3.2 s" in text
    assert "fault: outside the working volume: move the target in, or check [volume]" in text


def test_the_picture_shows_the_margin_of_the_exposure() -> None:
    text = drawn(scene())
    for side in ("left", "right"):
        assert f"{side}: LED 2.1x above dim, 12x below clipping" in text


def test_a_long_remedy_is_not_cut_off() -> None:
    text = drawn(scene(replace(POSE, status=0, faults=1 << 1, warnings=1 << 10)))
    assert "resumes by itself" in " ".join(text.replace("│", " ").split())
    assert "for disk, line or permission" in " ".join(text.replace("│", " ").split())


def test_the_picture_shows_a_hang() -> None:
    assert "NOTHING NEW" in drawn(scene(fresh=False))


@pytest.mark.parametrize(
    ("values", "bars"), [((), ""), ((0.0, 0.0), BARS[0] * 2), ((0.0, 0.5, 1.0), BARS[0] + BARS[4] + BARS[7])]
)
def test_bars_reach_from_0_to_the_largest(values: tuple[float, ...], bars: str) -> None:
    assert sparkline(values) == bars


def test_lines_may_be_thinned_out() -> None:
    file = io.StringIO()
    view = PlainLines(Console(file=file), every_s=1.0)
    for at_s in (0.0, 0.4, 0.99, 1.0, 1.5, 2.5):
        view.show(scene(at_s=at_s))
    assert len(file.getvalue().splitlines()) == 3


@pytest.mark.parametrize(
    ("terminal", "term", "as_json", "kind"),
    [
        (True, "xterm", False, Picture),
        (True, "dumb", False, PlainLines),
        (False, "xterm", False, PlainLines),
        (True, "xterm", True, JsonLines),
    ],
)
def test_the_view_suits_where_the_output_goes(
    terminal: bool, term: str, as_json: bool, kind: type, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TERM", term)
    console = Console(file=io.StringIO(), force_terminal=terminal)
    with view_for(console, IDENTITY, as_json) as view:
        assert isinstance(view, kind)


def test_no_color_takes_the_colour_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm-256color")
    file = io.StringIO()
    faulty = scene(replace(POSE, status=0, faults=1))
    Console(file=file, force_terminal=True).print(picture_of(faulty, "Tripoint", ()))
    assert "\x1b[31m" not in file.getvalue()
    assert "\x1b[1;31m" not in file.getvalue()
