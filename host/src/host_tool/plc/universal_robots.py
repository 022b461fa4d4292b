"""Universal Robots: the Modbus signals that a program needs, as URScript."""

from collections.abc import Sequence

from host_tool.plc.requests import Request, Tag, command_register

REGISTER_INPUT, REGISTER_OUTPUT = 2, 3
UNIT_ID = 255
PORT = 502  # the robot connects to no other


def universal_robots(requests: Sequence[Request], host: str) -> str:
    """A register input for each value of one register, and the register output for commands; on demand only."""
    command = command_register()
    lines = [
        f"# Tripoint at {host}, port {PORT}: signals for Universal Robots, read and written on demand only.",
        "# Every register comes by a request of its own: latch, and then read tp_latched_single_... (448 to 463).",
        "# A register reads as 0 to 65535: of a signed one subtract 65536 from 32768 up.",
    ]
    lines += _signal(host, command.address, REGISTER_OUTPUT, "tp_command_word", command.meaning)
    for request in requests:
        for tag in request.tags:
            if tag.register.count == 1:
                lines += _signal(host, tag.register.address, REGISTER_INPUT, f"tp_{tag.name}", _meaning(tag))
    return "\n".join(lines) + "\n"


def _signal(host: str, address: int, kind: int, name: str, meaning: str) -> list[str]:
    return [
        f"# {meaning}",
        f'modbus_add_signal("{host}", {UNIT_ID}, {address}, {kind}, "{name}")',
        f'modbus_set_signal_update_frequency("{name}", 0)',
    ]


def _meaning(tag: Tag) -> str:
    return tag.comment + ("; signed" if tag.register.type == "i16" else "")
