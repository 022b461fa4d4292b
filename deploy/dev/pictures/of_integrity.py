"""The pictures of docs/concepts/integrity.md."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from look import BLUE, GREEN, ORANGE, SHADE, figure, write
from matplotlib.axes import Axes
from programs import DEMO, FACING, Programs, Vector, Verdict, times_s
from staging import Recording, rgb

CALIBRATION, TARGET = DEMO / "calibration.toml", DEMO / "target.toml"
RATE_HZ = 30
FAULTS = (
    "no_calibration",
    "left_camera_lost",
    "right_camera_lost",
    "not_seen_left",
    "not_seen_right",
    "ambiguous",
    "epipolar_gate",
    "geometry_gate",
    "outside_volume",
    "timing_bound",
    "decalibration",
)
TRIANGLE_MM = np.array([[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [64.0, 48.0, 0.0]])  # of deploy/demo/target.toml
BRIGHTENED = 0.45  # exponent
ROUND_S = 12.0  # of bumped-camera: in the second of three the right camera stands turned


def add_spans(axes: Axes, at_s: Vector, shown: Sequence[bool], row: float, colour: str) -> None:
    """A bar wherever it holds, from each verdict to the next: so long a client reads it."""
    lengths = np.maximum(np.diff(at_s, append=at_s[-1]), 0.0)
    spans = [(at, length) for at, length, one in zip(at_s, lengths, shown, strict=True) if one]
    axes.broken_barh(spans, (row - 0.36, 0.72), color=colour, linewidth=0, zorder=2)


# What happens, from second to second.
HAPPENINGS = (
    (1.0, 2.0, "an LED\ncovered,\nleft camera"),
    (3.0, 4.0, "all LEDs\ncovered"),
    (5.0, 6.0, "a second\ntarget"),
    (7.0, 8.0, "right\ncamera\nunplugged"),
    (9.0, 10.0, "left\ncamera\nstuck"),
    (11.375, 13.125, "outside\nthe volume"),
)
PERIOD_S = 14.0
RESTING_MM = (-50.0, -20.0, 400.0)


def way() -> list[tuple[float, tuple[float, float, float]]]:
    """At rest, then to the left by 70 mm and back, without a jerk."""
    x_mm, y_mm, z_mm = RESTING_MM
    moving = np.linspace(0.0, 1.0, 71)
    places = [(10.5 + 3.5 * one, (x_mm - 35.0 * (1.0 - np.cos(2.0 * np.pi * one)), y_mm, z_mm)) for one in moving]
    return [(0.0, RESTING_MM), *places]


def staged(programs: Programs) -> list[Verdict]:
    frames = round(PERIOD_S * RATE_HZ)
    main = programs.recording("main", frames, *programs.trajectory("main", way()), "--leds", "3")
    beside = [(t_s, (x + 30.0, y + 70.0, z)) for t_s, (x, y, z) in way()]
    other = programs.recording("other", frames, *programs.trajectory("other", beside), "--leds", "3", "--seed", "2")
    recording = Recording(main, RATE_HZ)
    points = programs.verdicts(main, CALIBRATION, TARGET)[RATE_HZ]["points"]
    left, right = ([point[side] for point in points] for side in ("left_px", "right_px"))
    (one, all_of_them, second, unplugged, stuck, _) = (happening[:2] for happening in HAPPENINGS)
    recording.cover("left", left[:1], *one)
    recording.cover("left", left, *all_of_them)
    recording.cover("right", right, *all_of_them)
    recording.add_lights(Recording(other, RATE_HZ), *second)
    recording.hold("left", *stuck)
    recording.unplug("right", *unplugged)
    config = programs.work / "narrow.toml"
    text = (DEMO / "demo.toml").read_text(encoding="utf-8").replace("min_mm = [-200,", "min_mm = [-85,")
    for file in ("calibration.toml", "target.toml"):
        text = text.replace(f'"{file}"', f'"{DEMO / file}"')
    config.write_text(text, encoding="utf-8")
    return programs.verdicts(main, CALIBRATION, TARGET, config)


def draw_timeline(programs: Programs, file: Path) -> None:
    verdicts = staged(programs)
    at_s = times_s(verdicts) - PERIOD_S  # the recording begins after one period
    rows = [("position_valid", GREEN, [one["valid"] for one in verdicts])]
    seen = {fault for one in verdicts for fault in one["faults"]}
    for fault in FAULTS:
        if fault in seen:
            rows.append((fault, ORANGE, [fault in one["faults"] for one in verdicts]))
    drawn, (axes,) = figure((7.6, 3.6))
    for row, (_, colour, shown) in enumerate(rows):
        add_spans(axes, at_s, shown, row, colour)
    for first_s, last_s, what in HAPPENINGS:
        axes.axvspan(first_s, last_s, color=SHADE, linewidth=0, zorder=0)
        axes.annotate(what, ((first_s + last_s) / 2.0, -0.6), ha="center", va="bottom", fontsize=10)
    axes.set_yticks(range(len(rows)), [name for name, _, _ in rows])
    axes.set(xlabel="time, s", xlim=(0.0, PERIOD_S), ylim=(len(rows) - 0.4, -0.6))
    axes.grid(visible=False)
    write(drawn, file)
    tell(at_s, verdicts)


def tell(at_s: Vector, verdicts: Sequence[Verdict]) -> None:
    before: list[str] | None = None
    for at, one in zip(at_s, verdicts, strict=True):
        if one["faults"] != before:
            print(f"pictures: {at:7.3f} s {', '.join(one['faults']) or 'valid'}")
        before = one["faults"]


def true_places_mm(recording: Path) -> tuple[Vector, Vector]:
    """The times, and the target's origin then; the target of the scenario keeps its orientation."""
    with (recording / "truth.csv").open(newline="", encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    places_mm = np.array([[float(row[column]) for column in ("x_mm", "y_mm", "z_mm")] for row in rows])
    return np.array([float(row["t_s"]) for row in rows]), places_mm


def error_of_points_mm(verdict: Verdict, origin_mm: Vector) -> float | None:
    """RMS distance of the points from the LEDs; nothing unless each LED has one."""
    leds_mm = origin_mm + TRIANGLE_MM * np.array([1.0, -1.0, -1.0])  # turned by 180 degrees about x
    points_mm = np.array([point["position_mm"] for point in verdict["points"]])
    if len(points_mm) != len(leds_mm):
        return None
    away_mm = np.linalg.norm(points_mm[:, None] - leds_mm[None], axis=2)
    return float(np.sqrt(np.mean(away_mm.min(axis=0) ** 2)))


def draw_knock(programs: Programs, file: Path) -> None:
    recording = programs.recording(
        "knock", round(3 * ROUND_S * RATE_HZ), "--scenario", "bumped-camera", "--leds", "3", "--format", "jpg"
    )
    verdicts = programs.verdicts(recording, CALIBRATION, TARGET)
    truth_s, truth_mm = true_places_mm(recording)
    at_s = times_s(verdicts)
    verdicts = [one for one, at in zip(verdicts, at_s, strict=True) if at <= truth_s[-1]]
    at_s = at_s[: len(verdicts)]
    places_mm = np.array([np.interp(at_s, truth_s, truth_mm[:, axis]) for axis in range(3)]).T
    errors_mm = [error_of_points_mm(one, place) for one, place in zip(verdicts, places_mm, strict=True)]
    for at, one, place_mm in zip(at_s - truth_s[0], verdicts, places_mm, strict=True):
        if ROUND_S <= at < 2 * ROUND_S and one["valid"]:
            off_mm = np.linalg.norm(one["position_mm"] - place_mm)
            print(f"pictures: {at:7.3f} s knocked and valid, off by {off_mm:.2f} mm")
    sizes_mm = [one["decalibration_mm"] for one in verdicts]
    at_s -= truth_s[0]
    drawn, (top, bottom) = figure((7.6, 4.4), rows=2, sharex=True, height_ratios=(2.2, 1.0))
    top.plot(at_s, np.array(errors_mm, dtype=float), color=BLUE, linewidth=1.2)
    top.plot(at_s, np.array(sizes_mm, dtype=float), color=ORANGE, linestyle="--")
    top.annotate("error of the points", (12.3, 3.6), color=BLUE, ha="right")
    top.annotate("register 744,\ndecalibration", (25.3, 1.4), color=ORANGE)
    top.annotate("right camera turned\nby 0.1 degrees", (2 * ROUND_S - 0.3, 0.15), ha="right")
    top.set(ylabel="mm", ylim=0.0)
    rows = (
        ("pose valid", GREEN, [one["orientation_valid"] for one in verdicts]),
        ("geometry_gate", ORANGE, ["geometry_gate" in one["faults"] for one in verdicts]),
        ("decalibration", ORANGE, ["decalibration" in one["faults"] for one in verdicts]),
    )
    for row, (_, colour, shown) in enumerate(rows):
        add_spans(bottom, at_s, shown, row, colour)
    bottom.set_yticks(range(len(rows)), [name for name, _, _ in rows])
    bottom.set(xlabel="time, s", xlim=(0.0, 3 * ROUND_S), ylim=(len(rows) - 0.4, -0.6))
    bottom.grid(visible=False)
    for axes in (top, bottom):
        axes.axvspan(ROUND_S, 2 * ROUND_S, color=SHADE, linewidth=0, zorder=0)
    write(drawn, file)
    tell(at_s, verdicts)


def draw_mirror(programs: Programs, file: Path) -> None:
    recording = beside_its_image(programs)
    drawn, panels = figure((7.6, 2.9), columns=2, sharex=True, sharey=True)
    for axes, what in zip(panels, ("LEDs and their image in a mirror", "the same, LEDs covered"), strict=True):
        verdict = programs.verdicts(recording.folder, CALIBRATION, TARGET)[-1]
        axes.imshow(rgb(recording.picture("left", RATE_HZ // 2)) ** BRIGHTENED, interpolation="nearest")
        outcome = "pose valid" if verdict["orientation_valid"] else "no pose: " + ", ".join(verdict["faults"])
        axes.set(title=f"{what}\n{outcome}", xlim=(160, 610), ylim=(380, 150), xticks=[], yticks=[])
        add_sides(axes, verdict, GREEN if verdict["orientation_valid"] else ORANGE)
        for side in ("left", "right"):
            recording.cover(side, [point[f"{side}_px"] for point in verdict["points"]], 0.0, 1.0)
        print(f"pictures: {what}: {outcome}")
    write(drawn, file)


def beside_its_image(programs: Programs) -> Recording:
    """A second of a target at rest, and of what a mirror shows of it: the triangle with its back to the cameras."""
    recordings = []
    for name, place_mm, turned, peak in (
        ("target", (-85.0, 25.0, 400.0), FACING, "1.5"),
        ("image", (75.0, 25.0, 500.0), "0.97,0,0,0.24", "0.8"),
    ):
        still = programs.trajectory(name, [(0.0, place_mm), (1.0, place_mm)], turned)
        folder = programs.recording(name, RATE_HZ, *still, "--leds", "3", "--led-peak", peak)
        recordings.append(Recording(folder, RATE_HZ))
    target, image = recordings
    target.add_lights(image, 0.0, 1.0)
    return target


def add_sides(axes: Axes, verdict: Verdict, colour: str) -> None:
    """The triangle of the points, each side with its length as measured beside it."""
    points = verdict["points"]
    middle_px = np.mean([point["left_px"] for point in points], axis=0)
    for one, other in ((0, 1), (1, 2), (2, 0)):
        ends_px = np.array([points[one]["left_px"], points[other]["left_px"]])
        length_mm = np.linalg.norm(np.subtract(points[one]["position_mm"], points[other]["position_mm"]))
        axes.plot(*ends_px.T, color=colour, linewidth=1.5)
        along_px = ends_px[1] - ends_px[0]
        outwards = np.array([along_px[1], -along_px[0]])
        outwards *= np.sign(outwards @ (ends_px.mean(axis=0) - middle_px))
        at_px = ends_px.mean(axis=0) + 5.0 * outwards / np.linalg.norm(outwards)
        horizontal = "left" if outwards[0] > 0.0 else "right"
        vertical = "top" if outwards[1] > 0.0 else "bottom"
        text = f"{length_mm:.1f} mm"
        axes.annotate(text, at_px, color="white", ha=horizontal, va=vertical, fontsize=11)


def draw(programs: Programs, pictures: Path) -> None:
    draw_timeline(programs, pictures / "integrity_timeline.png")
    draw_knock(programs, pictures / "integrity_knock.png")
    draw_mirror(programs, pictures / "integrity_mirror.png")
