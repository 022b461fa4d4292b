"""The pictures of docs/concepts/detection.md: what `tripointd detect --explain` draws of cluttered scenes."""

from __future__ import annotations

from pathlib import Path

from look import save
from PIL import Image
from programs import Programs

#: The options of the scene, and the rows of the drawing that are shown; the rest is close-ups.
SCENES = {
    "explain_clutter.png": (("--red-lamps", "--seed", "41", "--tone", "webcam"), 1721),
    "explain_glare.png": (("--red-lamps", "--seed", "16"), 1961),
    "explain_bright.png": (("--white-level", "0.8", "--seed", "12"), 1411),
}
SHRUNK = 0.7


def draw(programs: Programs, pictures: Path) -> None:
    for name, (options, rows) in SCENES.items():
        scene = programs.recording(name, 1, "--scenario", "clutter", "--format", "jpg", "--quality", "95", *options)
        with Image.open(programs.explanation(scene / "left/00000000.jpg")) as whole:
            shown = whole.convert("RGB").crop((0, 0, whole.width, rows))
        shown = shown.resize((round(SHRUNK * shown.width), round(SHRUNK * shown.height)), Image.Resampling.LANCZOS)
        save(shown, pictures / name)
