"""The programs whose results the pictures show: rendered recordings go in, verdicts come out."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

TOP = Path(__file__).parents[3]
DEMO = TOP / "deploy/demo"
FACING = "0,1,0,0"  # a target whose LEDs shine towards the cameras: by 180 degrees about x
Vector = NDArray[np.float64]
Verdict = dict[str, Any]  # a line of tripointd replay


@dataclass(frozen=True, slots=True)
class Programs:
    """A folder of built programs, and one for what they write."""

    built: Path
    work: Path

    def recording(self, name: str, frames: int, *options: str) -> Path:
        """What tripoint-render draws; YUYV unless the options say otherwise."""
        folder = self.work / name
        command = [str(self.built / "tripoint-render"), "--frames", str(frames), "--out", str(folder), *options]
        subprocess.run(command, check=True)
        return folder

    def trajectory(
        self, name: str, places: Sequence[tuple[float, tuple[float, float, float]]], turned: str = FACING
    ) -> tuple[str, str]:
        """The option for a target that moves straight from place to place (s, mm), turned by a quaternion."""
        file = self.work / f"{name}.csv"
        rows = [f"{t_s},{x},{y},{z},{turned}" for t_s, (x, y, z) in places]
        file.write_text("\n".join(["t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz", *rows, ""]), encoding="utf-8")
        return "--trajectory", str(file)

    def calibrations(self, count: int) -> list[Path]:
        """Each in error by as much as it states."""
        run = subprocess.run(
            [self.built / "draw_calibrations", str(count)], check=True, stdout=subprocess.PIPE, text=True
        )
        first = 'format = "tripoint-calibration/1"'
        files = []
        for number, rest in enumerate(run.stdout.split(first)[1:]):
            files.append(self.work / f"calibration_{number}.toml")
            files[-1].write_text(first + rest, encoding="utf-8")
        return files

    def verdicts(
        self, recording: Path, calibration: Path, target: Path | None = None, config: Path = DEMO / "demo.toml"
    ) -> list[Verdict]:
        """What tripointd replay makes of it; without a target one LED is the target's origin."""
        command: list[str | Path] = [self.built / "tripointd", "replay", recording, "--config", config]
        command += ["--calibration", calibration]
        if target:
            command += ["--target", target]
        run = subprocess.run([*command, "--json"], check=True, stdout=subprocess.PIPE, text=True)
        return [json.loads(line) for line in run.stdout.splitlines()]

    def explanation(self, picture: Path) -> Path:
        """What tripointd detect draws of a picture."""
        folder = self.work / "why"
        subprocess.run(
            [self.built / "tripointd", "detect", picture, "--explain", folder], check=True, stdout=subprocess.DEVNULL
        )
        return folder / f"{picture.stem}.explain.png"


def positions_mm(verdicts: Sequence[Verdict]) -> Vector:
    """Of the valid ones, one row each."""
    return np.array([one["position_mm"] for one in verdicts if one["valid"]])


def times_s(verdicts: Sequence[Verdict]) -> Vector:
    return np.array([one["t_ns"] for one in verdicts]) * 1e-9
