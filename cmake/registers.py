"""Makes and checks what comes from firmware/contract/registers.toml; `python3 cmake/registers.py` says how."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from register_map.check import problems
from register_map.header import header
from register_map.model import MapError, RegisterMap, load
from register_map.page import page
from register_map.structured_text import SECTIONS, outdated, with_constants

ROOT = Path(__file__).resolve().parents[1]
MAP = ROOT / "firmware" / "contract" / "registers.toml"
PAGE = ROOT / "docs" / "reference" / "registers.md"
PLC = ROOT / "deploy" / "plc"
USAGE = """usage: python3 cmake/registers.py VERB
  header FILE   write the C++ header
  docs          write docs/reference/registers.md and the constants in deploy/plc
  check         the map is sound, the page and the constants up to date"""


def run(arguments: list[str]) -> int:
    """Do what the command line says; 0 well, 1 the map or the page is wrong, 2 usage."""
    match arguments:
        case ["header", target]:
            return _write(Path(target), header)
        case ["docs"]:
            return _write(PAGE, page) or _say(_write_constants())
        case ["check"]:
            return _say(verdict(MAP, PAGE) + plc_verdict(MAP, PLC))
        case _:
            print(USAGE, file=sys.stderr)
            return 2


def verdict(source: Path, reference: Path) -> list[str]:
    """What is wrong with the map `source` or its page `reference`; empty when all is well."""
    try:
        register_map = load(source)
        written = reference.read_text(encoding="utf-8")
    except (MapError, OSError) as error:
        return [str(error)]
    found = problems(register_map)
    if not found and written != page(register_map):
        found = [f"{reference} is not what {source} says: run `make docs`"]
    return found


def plc_verdict(source: Path, folder: Path) -> list[str]:
    """What is wrong with the constants of the Structured Text in `folder`; empty when all is well."""
    try:
        return [f"{file} is not what {source} says: run `make docs`" for file in outdated(folder, load(source))]
    except (MapError, OSError) as error:
        return [str(error)]


def _write_constants() -> list[str]:
    try:
        register_map = load(MAP)
        for file in (PLC / name for name in SECTIONS):
            text = with_constants(file.name, file.read_text(encoding="utf-8"), register_map)
            file.write_text(text, encoding="utf-8")
    except (MapError, OSError) as error:
        return [str(error)]
    return []


def _write(target: Path, form: Callable[[RegisterMap], str]) -> int:
    try:
        register_map = load(MAP)
    except (MapError, OSError) as error:
        return _say([str(error)])
    found = problems(register_map)
    if not found:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(form(register_map), encoding="utf-8")
    return _say(found)


def _say(found: list[str]) -> int:
    for problem in found:
        print(f"registers: {problem}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:]))
