"""The two simulated cameras as seen from inside the virtual machine: plug, unplug, find, give orders.

The camera program runs on the host, where it does not load the emulated processor; a cable is a TCP connection to it
that is handed to the kernel's vhci_hcd.
"""

import socket
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

HOST = "10.0.2.2"  # the host, in QEMU's user network
VHCI = Path("/sys/devices/platform/vhci_hcd.0")
VIDEO = Path("/sys/class/video4linux")
HIGH_SPEED = 3  # enum usb_device_speed of the kernel
SERIALS = {"left": "LEFT-001", "right": "RIGHT-001"}
VHCI_PORTS = {"left": 0, "right": 1}
SIDES = ("left", "right")

T = TypeVar("T")


def eventually(what: str, look: Callable[[], T | None], limit_s: float = 60.0) -> T:
    """Waits until `look` gives something (not None, not False). Raises AssertionError naming `what` after the limit."""
    end = time.monotonic() + limit_s
    while True:
        seen = look()
        if seen is not None and seen is not False:
            return seen
        if time.monotonic() > end:
            raise AssertionError(f"{what}: not within {limit_s:g} s")
        time.sleep(0.1)


@dataclass(frozen=True, slots=True)
class Cameras:
    """Where the camera program listens on the host."""

    left: int
    right: int
    control: int

    def order(self, text: str) -> str:
        """Sends one order to the camera program, for example "hang left"; returns its answer."""
        with socket.create_connection((HOST, self.control), timeout=10) as connection:
            connection.sendall(text.encode() + b"\n")
            return connection.makefile().readline().strip()

    def settings(self, side: str) -> dict[str, int]:
        """What the camera itself holds, not what the driver remembers."""
        pairs = (word.split("=") for word in self.order(f"settings {side}").split())
        return {name: int(value) for name, value in pairs}

    def plug(self, side: str) -> str:
        """Connects the camera and waits for its video node, which is returned."""
        port = self.left if side == "left" else self.right
        with socket.create_connection((HOST, port), timeout=10) as cable:
            cable.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            number = VHCI_PORTS[side]
            (VHCI / "attach").write_text(f"{number} {cable.fileno()} {number + 1} {HIGH_SPEED}")
        return eventually(f"video node of camera {side}", lambda: node_of(side))

    def unplug(self, side: str) -> None:
        """Pulls the cable and waits until the kernel has taken the device away."""
        if self.order(f"unplug {side}") != "done":
            raise AssertionError(f"the camera program refused to unplug {side}")
        eventually(f"camera {side} gone", lambda: node_of(side) is None)


def load_drivers() -> None:
    for module in ("vhci-hcd", "uvcvideo"):
        subprocess.run(["modprobe", module], check=True)


def node_of(side: str) -> str | None:
    """The node that carries pictures (index 0; index 1 carries metadata) of the camera with the side's serial."""
    for entry in VIDEO.iterdir() if VIDEO.exists() else ():
        try:
            index = (entry / "index").read_text().strip()
            serial = (entry / "device" / ".." / "serial").read_text().strip()
        except OSError:  # it went away while we looked
            continue
        node = Path("/dev") / entry.name
        if index == "0" and serial == SERIALS[side] and node.exists():
            return str(node)
    return None
