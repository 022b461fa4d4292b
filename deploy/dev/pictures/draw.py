"""Draws the plots of docs/pictures anew, from what the programs measure in rendered pictures.

usage: draw.py FOLDER_OF_PROGRAMS FOLDER_OF_PICTURES [detection|uncertainty|integrity]...
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import of_detection
import of_integrity
import of_uncertainty
from programs import Programs

PAGES = {"detection": of_detection.draw, "uncertainty": of_uncertainty.draw, "integrity": of_integrity.draw}


def main(built: str, pictures: str, *pages: str) -> None:
    for page in pages or PAGES:
        with tempfile.TemporaryDirectory(prefix="tripoint-pictures-") as work:
            PAGES[page](Programs(Path(built), Path(work)), Path(pictures))


if __name__ == "__main__":
    main(*sys.argv[1:])
