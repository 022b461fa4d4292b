"""Recordings in which something happens: LEDs covered, a second target, a camera unplugged or stuck."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

WIDTH_PX, HEIGHT_PX = 640, 480
COVER_PX = 24  # half the side of what covers an LED
Bytes = NDArray[np.uint8]
Pixel = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Recording:
    """A folder of YUYV pictures whose frames are equally far apart."""

    folder: Path
    rate_hz: float

    def numbers(self, first_s: float, last_s: float) -> range:
        return range(round(first_s * self.rate_hz), round(last_s * self.rate_hz))

    def file(self, side: str, number: int) -> Path:
        return self.folder / side / f"{number:08d}.yuyv"

    def picture(self, side: str, number: int) -> Bytes:
        """Rows of pairs of pixels: Y U Y V."""
        return np.fromfile(self.file(side, number), dtype=np.uint8).reshape(HEIGHT_PX, WIDTH_PX // 2, 4)

    def cover(self, side: str, places: Sequence[Pixel], first_s: float, last_s: float) -> None:
        """Something as dark as the wall hides what is there: rows and columns beside it are shown instead."""
        for number in self.numbers(first_s, last_s):
            picture = self.picture(side, number)
            for u_px, v_px in places:
                hide(picture, u_px, v_px)
            picture.tofile(self.file(side, number))

    def add_lights(self, other: Recording, first_s: float, last_s: float) -> None:
        """What shines in the other recording shines here too, in both cameras."""
        for side in ("left", "right"):
            for number in self.numbers(first_s, last_s):
                picture, more = self.picture(side, number), other.picture(side, number)
                brighter = more[..., 3] > picture[..., 3]  # redder: V
                picture[brighter] = more[brighter]
                picture.tofile(self.file(side, number))

    def hold(self, side: str, first_s: float, last_s: float) -> None:
        """The camera sends its picture again and again."""
        numbers = self.numbers(first_s, last_s)
        for number in numbers[1:]:
            shutil.copyfile(self.file(side, numbers[0]), self.file(side, number))

    def unplug(self, side: str, first_s: float, last_s: float) -> None:
        """Its frames are missing; the line is told that the camera is lost and that it is back."""
        table = self.folder / "frames.csv"
        header, *rows = table.read_text(encoding="utf-8").splitlines()
        numbers = self.numbers(first_s, last_s)
        kept = [header + ",event"]
        for row in rows:
            of_side, number, _, arrival_ns = row.split(",")
            if of_side != side or int(number) not in numbers:
                kept.append(row + ",")
            elif int(number) in (numbers[0], numbers[-1]):
                kept.append(f"{side},0,0,{arrival_ns},{'lost' if int(number) == numbers[0] else 'back'}")
        table.write_text("\n".join(kept) + "\n", encoding="utf-8")


def hide(picture: Bytes, u_px: float, v_px: float) -> None:
    """The rows above take the place of a square around it."""
    top, left = max(0, round(v_px) - COVER_PX), max(0, (round(u_px) - COVER_PX) // 2)
    square = picture[top : round(v_px) + COVER_PX, left : (round(u_px) + COVER_PX) // 2]
    square[:] = picture[max(0, top - 1), left : left + square.shape[1]]


def rgb(picture: Bytes) -> NDArray[np.float64]:
    """Rows of red, green, blue from 0 to 1 (BT.601)."""
    luma = np.stack([picture[..., 0], picture[..., 2]], axis=-1).reshape(HEIGHT_PX, WIDTH_PX).astype(float)
    blue, red = (np.repeat(picture[..., channel], 2, axis=1).astype(float) - 128.0 for channel in (1, 3))
    channels = (luma + 1.402 * red, luma - 0.344 * blue - 0.714 * red, luma + 1.772 * blue)
    return np.clip(np.stack(channels, axis=-1) / 255.0, 0.0, 1.0)
