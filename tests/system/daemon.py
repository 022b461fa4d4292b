"""The real tripointd on simulated cameras, started on a free port and always stopped again."""

import os
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from host_tool.appliance.address import Address
from host_tool.appliance.unit import wait_until_answering
from host_tool.clock import MonotonicClock

REPOSITORY = Path(__file__).parents[2]
CONFIG = Path(os.environ.get("TRIPOINT_CONFIG", REPOSITORY / "deploy/demo/demo.toml"))
ONE_LED = "target.file="  # in place of the demo's three
START_S = 20.0  # rendering starts, also on a busy machine
STOP_S = 1.0  # the promise
TIMEOUT_S = 2.0


def binary() -> str:
    """The program under test; skips aloud where it was not built."""
    path = Path(os.environ.get("TRIPOINT_BIN", REPOSITORY / "build/bin/tripointd"))
    if not path.is_file():
        pytest.skip(f"no tripointd at {path}: run `make build`, or set TRIPOINT_BIN")
    return str(path)


def renderer() -> str:
    """The program that renders recordings; skips aloud where it was not built."""
    path = Path(os.environ.get("TRIPOINT_RENDER", REPOSITORY / "build/bin/tripoint-render"))
    if not path.is_file():
        pytest.skip(f"no tripoint-render at {path}: run `make build`, or set TRIPOINT_RENDER")
    return str(path)


def tool(name: str) -> str:
    """Another program that a test needs; skips aloud where it is missing."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed: see deploy/dev/packages.txt")
    return path


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@dataclass(frozen=True)
class Daemon:
    """A running tripointd."""

    process: subprocess.Popen[bytes]
    port: int

    @property
    def device(self) -> str:
        return f"127.0.0.1:{self.port}"

    @property
    def address(self) -> Address:
        return Address("127.0.0.1", self.port)


@contextmanager
def daemon(log: Path, *settings: str, config: Path = CONFIG, through: tuple[str, ...] = ()) -> Iterator[Daemon]:
    """Runs with `settings` (table.key=value) over the demo's configuration; what it says goes to `log`.

    `through` is a command that becomes the one after it, such as prlimit.
    """
    port = free_port()
    chosen = [argument for setting in (f"modbus.port={port}", *settings) for argument in ("--set", setting)]
    with log.open("wb") as output:
        command = [*through, binary(), "run", "--config", str(config), *chosen]
        process = subprocess.Popen(command, stderr=output, stdout=output)
        try:
            wait_until_answering(Address("127.0.0.1", port), TIMEOUT_S, START_S, MonotonicClock())
            yield Daemon(process, port)
        finally:
            process.terminate()
            try:
                process.wait(timeout=10.0 * STOP_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def finished(*arguments: str, limit_s: float = 10.0) -> subprocess.CompletedProcess[str]:
    """A run that is expected to end by itself."""
    return subprocess.run([binary(), *arguments], capture_output=True, text=True, timeout=limit_s, check=False)
