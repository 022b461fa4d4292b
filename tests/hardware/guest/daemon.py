"""The product under test: `tripointd run` on the two cameras, and what it publishes over Modbus."""

import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import modbus_client
from cameras import eventually
from environment import Environment

PORT = 1502
FORMATS = {"YUYV": "yuyv", "MJPG": "mjpeg"}  # V4L2's name -> the configuration's
RIG = Path(__file__).resolve().parent.parent / "rig"


@dataclass(slots=True)
class Daemon:
    environment: Environment
    format_name: str
    process: subprocess.Popen[bytes] | None = field(default=None)

    @property
    def log(self) -> Path:
        return self.environment.out / f"tripointd_{self.format_name}.log"

    def start(self) -> None:
        """Starts the program and waits until it answers; the cameras may still be missing."""
        program = self.environment.programs / "tripointd"
        arguments = [
            "run",
            "--config",
            str(RIG / "tripoint.toml"),
            "--set",
            f"cameras.format={FORMATS[self.format_name]}",
        ]
        with self.log.open("wb") as log:
            self.process = subprocess.Popen([program, *arguments], stdout=log, stderr=log)
        eventually("an answer over Modbus", self.first_reading)

    def stop(self) -> int:
        """Asks the program to end; returns its exit code. One that hangs is killed and gives -9."""
        if self.process is None:
            return 0
        self.process.terminate()
        try:
            return self.process.wait(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()

    def first_reading(self) -> modbus_client.Reading | None:
        """State and pose; None while nobody listens."""
        try:
            return self.reading()
        except ConnectionRefusedError:
            return None

    def reading(self) -> modbus_client.Reading:
        """The newest state and pose."""
        if self.process is not None and self.process.poll() is not None:
            raise AssertionError(f"tripointd ended with {self.process.returncode}: {self.log.read_text()[-2000:]}")
        return modbus_client.read_pose(PORT)

    def valid_reading(self) -> modbus_client.Reading | None:
        """The newest state and pose, if the position may be used."""
        seen = self.reading()
        return seen if seen.valid else None
