"""Checks the register map: sound in itself, and docs/reference/registers.md says the same.

usage: check_registers.py [MAP PAGE]
Prints one line for each violation and exits 1 when there is any.
"""

from __future__ import annotations

import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cmake"))

from registers import MAP, PAGE, verdict  # noqa: E402  (the generator is beside the build files, not installed)

__all__ = ["MAP", "PAGE", "main", "verdict"]


def main() -> int:
    """Check the map of the tree, or the one named."""
    source, page = (Path(argument) for argument in sys.argv[1:3]) if len(sys.argv) == 3 else (MAP, PAGE)
    found = verdict(source, page)
    print("\n".join(found) if found else "registers: the map is sound and its page up to date")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
