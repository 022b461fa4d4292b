"""The reference page names exactly the errors, exit codes and commands that exist."""

import re
from pathlib import Path

from host_tool.cli.main import host_tool
from host_tool.errors import ExitCode
from host_tool.trajectories.paths import SCENARIOS

REPOSITORY = Path(__file__).parents[2]
PAGE = (REPOSITORY / "docs/reference/host-tool.md").read_text(encoding="utf-8")
SOURCES = "".join(file.read_text(encoding="utf-8") for file in (REPOSITORY / "host/src").rglob("*.py"))


def test_every_error_code_is_explained_and_none_is_invented() -> None:
    raised = set(re.findall(r'"(E-[A-Z]{3}-\d\d)\b', SOURCES))
    assert raised == set(re.findall(r"^\| `(E-[A-Z]{3}-\d\d)`", PAGE, re.M))


def test_every_exit_code_is_explained() -> None:
    assert {str(int(code)) for code in ExitCode} == set(re.findall(r"^\| (\d+) \|", PAGE, re.M))


def test_every_command_and_scenario_is_named() -> None:
    for name in [*host_tool.commands, *SCENARIOS]:
        assert f"`{name}" in PAGE
