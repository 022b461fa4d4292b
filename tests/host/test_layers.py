"""Who may import whom in host_tool; the check is itself shown to refuse."""

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "host/src/host_tool"
ONLY_IN = {
    "click": {"cli"},
    "rich": {"cli"},
    "pymodbus": {"appliance"},
    "socket": {"appliance"},
    "asyncio": {"appliance"},
    "http": {"appliance"},
    "urllib": {"appliance"},
}
MAY_USE = {
    "errors": set[str](),
    "clock": set[str](),
    "contract": {"errors"},
    "appliance": {"errors", "clock", "contract"},
    "trajectories": {"errors"},
    "watching": {"errors", "clock", "contract", "trajectories"},
    "diagnostics": {"errors", "contract", "appliance"},
    "plc": {"errors", "contract"},
    "demo": {"errors", "contract", "watching"},
}  # cli may use everything, and nobody uses cli


def imported_by(source: str) -> set[str]:
    modules: set[str] = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            modules |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            modules |= {f"{node.module}.{alias.name}" for alias in node.names}
    return modules


def violations(room: str, source: str) -> list[str]:
    found = []
    for module in sorted(imported_by(source)):
        top, *rest = module.split(".")
        if room not in ONLY_IN.get(top, {room}):
            found.append(f"{room} imports {top}")
        if top == "host_tool" and room in MAY_USE and rest[0] not in MAY_USE[room] | {room}:
            found.append(f"{room} imports host_tool.{rest[0]}")
    return found


def room_of(file: Path) -> str:
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


@pytest.mark.parametrize("file", sorted(PACKAGE.rglob("*.py")), ids=lambda file: str(file.relative_to(PACKAGE)))
def test_a_file_imports_only_what_its_room_may(file: Path) -> None:
    assert violations(room_of(file), file.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    ("room", "source"),
    [
        ("contract", "import socket"),
        ("watching", "from pymodbus.client import ModbusTcpClient"),
        ("diagnostics", "import rich.console"),
        ("appliance", "from host_tool.cli.main import run"),
        ("contract", "from host_tool.appliance import unit"),
    ],
)
def test_a_planted_violation_is_refused(room: str, source: str) -> None:
    assert violations(room, source) != []


def test_every_room_has_rules() -> None:
    rooms = {room_of(file) for file in PACKAGE.rglob("*.py")}
    assert rooms - {"cli", "__init__"} == set(MAY_USE)
