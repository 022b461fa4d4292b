"""How the pictures look: one width, colours that the colour-blind can tell apart (Okabe and Ito), no decoration."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from PIL import Image

BLUE, ORANGE, GREEN, GREY, BLACK = "#0072b2", "#d55e00", "#009e73", "#6b6b6b", "#000000"
SHADE = "#ebebeb"
DPI = 130
LARGEST_BYTES = 150_000
COLOURS = (256, 128, 64, 56, 48, 40, 32)

STYLE = {
    "font.size": 11,
    "axes.titlesize": 11,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e3e3e3",
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 2.0,
}


def figure(size_in: tuple[float, float], rows: int = 1, columns: int = 1, **more: Any) -> tuple[Figure, list[Axes]]:
    """Empty axes, row by row."""
    mpl.use("Agg")
    mpl.rcParams.update(STYLE)
    drawn, axes = plt.subplots(rows, columns, figsize=size_in, layout="constrained", squeeze=False, **more)
    return drawn, list(axes.flat)


def write(drawn: Figure, file: Path) -> None:
    """The same bytes for the same drawing."""
    pixels = io.BytesIO()
    drawn.savefig(pixels, dpi=DPI, format="png", bbox_inches="tight")
    plt.close(drawn)
    with Image.open(pixels) as image:
        save(image.convert("RGB"), file)


def save(image: Image.Image, file: Path) -> None:
    """With as many colours as the size permits."""
    for colours in COLOURS:
        image.quantize(colours, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(file, optimize=True)
        if file.stat().st_size <= LARGEST_BYTES:
            break
    print(f"pictures: {file.name}, {file.stat().st_size / 1000:.0f} kB")
