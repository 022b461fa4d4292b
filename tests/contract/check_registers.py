"""Checks the register map: sound in itself, docs/reference/registers.md and the constants in deploy/plc say the same.

usage: check_registers.py [MAP PAGE PLC]
Prints one line for each violation and exits 1 when there is any.
"""

from __future__ import annotations

import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cmake"))

from registers import MAP, PAGE, PLC, plc_verdict, verdict  # noqa: E402  (the generator is beside the build files, not installed)

__all__ = ["MAP", "PAGE", "PLC", "main", "plc_verdict", "verdict"]


def main() -> int:
    """Check the map of the tree, or the one named."""
    named = tuple(Path(argument) for argument in sys.argv[1:4])
    source, page, plc = named if len(named) == 3 else (MAP, PAGE, PLC)
    found = verdict(source, page) or plc_verdict(source, plc)
    print("\n".join(found) if found else "registers: the map is sound, its page and the PLC's constants up to date")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
