"""The pictures of docs/concepts/uncertainty.md."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from look import BLACK, BLUE, GREEN, GREY, ORANGE, figure, write
from matplotlib.axes import Axes
from matplotlib.patches import Ellipse
from programs import DEMO, Programs, Vector, positions_mm

UNITS = 300
READINGS = 300
PLACE_MM = (20.0, -10.0, 400.0)
NOISY = ("--read-noise", "0.02")  # ten times that of the default sensor
SHOWN = 5  # the unit of the left picture: its calibration errs more than most, sideways
MOST_OF_PLANE = 5.991  # 95 % of chi-square with two degrees of freedom
MOST_OF_SPACE = 7.815  # with three
X, Y, Z = 0, 1, 2


@dataclass(frozen=True, slots=True)
class AtRest:
    """One LED at rest as many units measure it: the same pictures, each unit with its own calibration in error."""

    errors_mm: Vector  # unit, reading, axis
    covariance_mm2: Vector  # of one reading, whole
    shared_mm2: Vector  # the calibration's part of it
    inside: Vector  # unit, reading: the truth lies in the stated ellipsoid


def at_rest(programs: Programs) -> AtRest:
    still = programs.trajectory("still", [(0.0, PLACE_MM), (10.0, PLACE_MM)])
    recording = programs.recording("still", READINGS, *still, *NOISY)
    errors, inside = [], []
    for calibration in programs.calibrations(UNITS):
        verdicts = [one for one in programs.verdicts(recording, calibration) if one["valid"]]
        off_mm = positions_mm(verdicts) - np.array(PLACE_MM)
        spread_mm2 = np.array([one["covariance"] for one in verdicts])
        chi2 = np.einsum("ni,nij,nj->n", off_mm, np.linalg.inv(spread_mm2), off_mm)
        errors.append(off_mm)
        inside.append(chi2 <= MOST_OF_SPACE)
    shared_mm2 = np.array(verdicts[0]["covariance_shared"])
    count = min(map(len, errors))
    print(f"pictures: {UNITS} units, {count} readings each")
    return AtRest(
        errors_mm=np.array([one[:count] for one in errors]),
        covariance_mm2=np.median(spread_mm2, axis=0),
        shared_mm2=shared_mm2,
        inside=np.array([one[:count] for one in inside]),
    )


def add_ellipse(axes: Axes, covariance_mm2: Vector) -> None:
    """That holds 95 % of the errors, as the covariance states them, seen from above."""
    sizes, ways = np.linalg.eigh(covariance_mm2[np.ix_([X, Z], [X, Z])])
    width, height = 2.0 * np.sqrt(MOST_OF_PLANE * sizes)
    angle_deg = np.degrees(np.arctan2(ways[1, 0], ways[0, 0]))
    axes.add_patch(Ellipse((0.0, 0.0), width, height, angle=angle_deg, fill=False, color=ORANGE, linewidth=2.0))


def draw_top_view(rest: AtRest, file: Path) -> None:
    drawn, (left, right) = figure((6.2, 4.8), columns=2, sharex=True, sharey=True)
    each = np.arange(UNITS) % rest.errors_mm.shape[1]
    clouds = (
        (left, rest.errors_mm[SHOWN], f"one unit, {rest.errors_mm.shape[1]} readings"),
        (right, rest.errors_mm[np.arange(UNITS), each], f"{UNITS} units, one reading each"),
    )
    for axes, errors_mm, title in clouds:
        axes.scatter(errors_mm[:, X], errors_mm[:, Z], s=8, color=BLUE, alpha=0.6, linewidths=0)
        add_ellipse(axes, rest.covariance_mm2)
        axes.plot(0.0, 0.0, "+", color=BLACK, markersize=14, markeredgewidth=2)
        axes.set(title=title, xlabel="sideways: error of x, mm", aspect="equal", xlim=(-0.75, 0.75))
    left.annotate("truth", (-0.06, 0.05), ha="right")
    left.annotate("95 %,\nas stated", (0.36, 0.8), color=ORANGE)
    left.set_ylabel("depth: error of z, mm")
    write(drawn, file)
    inside = rest.inside[np.arange(UNITS), each]
    off_mm = rest.errors_mm[SHOWN].mean(axis=0).round(2)
    print(
        f"pictures: {inside.sum()} of {UNITS} units in their own ellipsoid; the mean of the one is off by {off_mm} mm"
    )


def draw_mean(rest: AtRest, file: Path) -> None:
    drawn, (axes,) = figure((6.2, 3.2))
    counts = [2**n for n in range(9)]
    looks = ((Z, "depth (z)", BLUE, "o-", (1.35, 0.215)), (X, "sideways (x)", ORANGE, "s-", (40.0, 0.185)))
    for axis, name, colour, line, place in looks:
        errors_mm = [rms(means(rest.errors_mm[:, :, axis], n)) for n in counts]
        shared_mm = float(np.sqrt(rest.shared_mm2[axis, axis]))
        axes.axhline(shared_mm, color=GREY, linestyle="--", linewidth=1.5)
        axes.semilogx(counts, errors_mm, line, color=colour)
        axes.annotate(name, place, color=colour)
        alone_mm, most_mm, alike_mm = errors_mm[0], errors_mm[-1], rest.errors_mm[:, :, axis].mean()
        print(f"pictures: {name}: RMS {alone_mm:.3f} mm of one, {most_mm:.3f} of the mean of {counts[-1]},")
        print(
            f"pictures:   of it {alike_mm:+.3f} mm in all units, by the place; the calibration's part {shared_mm:.3f}"
        )
    axes.annotate("dashed: the calibration's part, as stated", (1.0, 0.045), color=GREY)
    axes.set(xlabel="readings in the mean", ylabel=f"RMS error of {UNITS} units, mm", ylim=(0.0, 0.25))
    axes.set_xticks(counts, [str(n) for n in counts])
    axes.minorticks_off()
    write(drawn, file)


def means(values: Vector, count: int) -> Vector:
    """Of every `count` readings in a row."""
    whole = values.shape[1] // count * count
    of_each: Vector = values[:, :whole].reshape(len(values), -1, count).mean(axis=2)
    return of_each


def rms(values: Vector) -> float:
    return float(np.sqrt(np.mean(values**2)))


def draw_depth_and_size(programs: Programs, file: Path) -> None:
    drawn, (left, right) = figure((7.6, 3.4), columns=2)
    calibration = programs.work / "calibration_0.toml"
    along = programs.trajectory("along", [(0.0, (0.0, 0.0, 260.0)), (20.0, (0.0, 0.0, 590.0))])
    verdicts = [one for one in programs.verdicts(programs.recording("along", 300, *along), calibration) if one["valid"]]
    z_mm = positions_mm(verdicts)[:, Z]
    expanded_mm = 2.0 * np.sqrt(np.array([np.diag(one["covariance"])[:3] for one in verdicts]))
    left.scatter(z_mm, expanded_mm[:, Z], s=10, color=BLUE, linewidths=0, label="depth (z)")
    left.scatter(z_mm, expanded_mm[:, X], s=10, color=ORANGE, marker="s", linewidths=0, label="sideways (x)")
    left.set(xlabel="distance from the cameras, mm", ylabel="uncertainty (k = 2), mm", title="one LED", ylim=0)
    left.legend(loc="upper left", handletextpad=0.2, markerscale=1.8)

    scales = np.array([0.5, 0.75, 1.0, 1.25, 1.5])
    expanded_deg = np.array([of_triangle_deg(programs, float(scale), calibration) for scale in scales])
    for axis, name, colour, line in ((X, "C (about x)", BLUE, "o-"), (Y, "B (about y)", ORANGE, "s--")):
        right.plot(100 * scales, expanded_deg[:, axis], line, color=colour, label=name)
    right.plot(100 * scales, expanded_deg[:, Z], "^:", color=GREEN, label="A (about z)")
    right.set(xlabel="longest side of the triangle, mm", ylabel="uncertainty (k = 2), degrees")
    right.set(title="three LEDs, facing the cameras", ylim=0)
    right.legend()
    write(drawn, file)
    for at_mm in (300, 400, 580):
        print(f"pictures: at {at_mm} mm k = 2 {expanded_mm[np.argmin(abs(z_mm - at_mm))].round(2)} mm")
    print(f"pictures: sides {100 * scales} mm: {expanded_deg.round(2).tolist()} degrees")


def of_triangle_deg(programs: Programs, scale: float, calibration: Path) -> Vector:
    """Expanded uncertainty about x, y and z of the demo's triangle, larger by `scale`, its middle 400 mm away."""
    text = (DEMO / "target.toml").read_text(encoding="utf-8")
    for at in ("[100, 0, 0]", "[64, 48, 0]"):
        place = [scale * float(number) for number in at.strip("[]").split(",")]
        text = text.replace(at, str(place))
    target = programs.work / f"triangle_{scale}.toml"
    target.write_text(text, encoding="utf-8")
    place_mm = (-55.0 * scale, 16.0 * scale, 400.0)
    still = programs.trajectory("triangle", [(0.0, place_mm), (1.0, place_mm)])
    recording = programs.recording(f"triangle_{scale}", 30, *still, "--leds", "3", "--target-scale", str(scale))
    verdicts = [one for one in programs.verdicts(recording, calibration, target) if one["orientation_valid"]]
    variances = np.array([np.diag(one["covariance"])[3:] for one in verdicts])
    expanded_deg: Vector = 2.0 * np.degrees(np.sqrt(np.median(variances, axis=0)))
    return expanded_deg


def draw(programs: Programs, pictures: Path) -> None:
    rest = at_rest(programs)
    draw_top_view(rest, pictures / "uncertainty_top_view.png")
    draw_mean(rest, pictures / "uncertainty_mean.png")
    draw_depth_and_size(programs, pictures / "uncertainty_depth.png")
