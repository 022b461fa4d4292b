"""Where a unit is: HOST[:PORT]."""

from dataclasses import dataclass

from host_tool.errors import UsageError

DEFAULT_PORT = 1502


@dataclass(frozen=True, slots=True)
class Address:
    """A unit's Modbus server."""

    host: str
    port: int

    def __str__(self) -> str:
        return f"[{self.host}]:{self.port}" if ":" in self.host else f"{self.host}:{self.port}"


def address_from(text: str) -> Address:
    """Reads HOST, HOST:PORT, IPv6 or [IPv6]:PORT; raises UsageError E-USE-01."""
    host, port_text = text, str(DEFAULT_PORT)
    if text.startswith("["):
        host, _, rest = text[1:].partition("]")
        port_text = rest.removeprefix(":") or port_text
    elif text.count(":") == 1:
        host, _, port_text = text.partition(":")
    if not host or not (port_text.isascii() and port_text.isdigit()) or not 1 <= int(port_text) <= 65535:
        raise UsageError(
            "E-USE-01",
            f"device {text!r} is not HOST[:PORT]",
            "write for example 192.168.1.20:502, port 1 to 65535",
        )
    return Address(host, int(port_text))
