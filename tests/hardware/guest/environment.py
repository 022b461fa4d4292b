"""What the host told this run: ports of the cameras, folders of the pictures, where the programs are."""

import json
import os
from dataclasses import dataclass
from pathlib import Path

from cameras import Cameras


@dataclass(frozen=True, slots=True)
class Environment:
    out: Path
    programs: Path
    recordings: dict[str, Path]  # by V4L2 name of the format
    cameras: Cameras


def environment() -> Environment:
    out = Path(os.environ["TRIPOINT_OUT"])
    told = json.loads((out / "environment.json").read_text())
    return Environment(
        out=out,
        programs=Path(told["programs"]),
        recordings={"YUYV": Path(told["yuyv"]), "MJPG": Path(told["mjpeg"])},
        cameras=Cameras(**told["cameras"]),
    )
