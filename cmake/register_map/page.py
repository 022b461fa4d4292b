"""The register map as a reference page."""

from __future__ import annotations

from dataclasses import asdict

from register_map.model import Block, Name, Register, RegisterMap

INTRODUCTION = """\
<!-- Made from firmware/contract/registers.toml by `make docs`: change that file, not this one. -->
# Modbus registers, version {major}.{minor}

Modbus TCP; function codes 3, 4, 6, 16, 23 and 43/14; any unit id. Addresses count from 0 as on the wire; many PLC
tools count from 1, or write 30001 and 40001 for address 0. The image at 0 to {last} is readable as input registers
(FC 4) and as holding registers (FC 3), most significant word first. The same image stands at {mirror} to {mirror_last}
with the least significant word first (32 bits CDAB, 64 bits GHEFCDAB). Registers that are not listed read 0.

A request not wholly inside 0 to {last}, 1000, or {mirror} to {mirror_last} gets exception 02; a bad quantity, or a
request that does not fill its declared length, exception 03; another function, exception 01.

Every request is answered from one consistent image. Age, staleness and validity are decided when the answer is made.
Value = raw number x scale, in the unit given. "Unknown" is the raw number that stands for "not known or not valid".
"""

CLIENT = """\
## What a client does

1. Once per connection: 0 = 0x5450, 1 = {major}, 4 to 7 as expected (else the word order is wrong: add {mirror}).
2. Every 20 to 100 ms: one FC 3 for 32 to 147 (116 registers: state and pose in one answer).
3. Take the pose only if the answer came in time; 100 = 147; (101 AND 16#021C) = 16#000C, or for position alone
   (101 AND 16#0214) = 16#0004; 146 = the stored setup; age + own round trip and the uncertainties are under the
   application's limits. Where a datum watches the rig and the calibration must be verified: mask 16#621C = 16#600C.
   A new sample is a sequence other than the last (compare for unequal, it wraps).
4. Own timer: heartbeat unchanged for 500 ms is a communication fault, whatever the bits say. This also catches a
   gateway or proxy that answers from its cache. A new sequence is no heartbeat: a lost or returned camera, or stamps
   that cannot be joined, publish a sequence without a step of it.
5. Test the bits before touching a value: NaN in a comparison stops a TwinCAT runtime by default. There, or without
   64-bit integers, use the integer block and its age.
6. k = 2 holds per axis (95 %); all three at once 87 %.
7. Modbus authenticates nobody: own network segment, allow-list. Not a safety function: no person may depend on a
   value or line of this unit.

Latch: write 0 to 1000, see 40 = 0; write 256 + token, see 40 = that word and 41 = 2 (done) or 3 (failed); read 400 to
463. A client that reads one register per request (Universal Robots) must take its pose this way.

[The guide](../guides/plc.md) has this for each vendor, with programs.
"""

CONNECTIONS = """\
## Connections

| limit | value | what happens then |
|---|---|---|
| connections, all clients together | {most_connections} by default (`modbus.max_connections`) | see below |
| from the first byte of a request to its last | {frame_ms} ms | closed |
| until the client has taken its answer | {write_ms} ms | closed |
| without any request | {idle_ms} ms | closed |
| requests of one connection, sustained | one each {pace_us} us, after up to {burst} at once | the next answer waits |
| work of the server, all clients together | half of a processor | answers come some milliseconds later |
| not Modbus TCP: protocol id other than 0, length outside 2 to 254 | | closed |

An address has no fixed share. When all connections are taken, a newcomer from the address that holds most is refused;
any other takes the place of that address's longest silent connection; one that never asked counts as silent for longer
than any that did. An address that is not in `modbus.allowed_clients` (empty: everyone) is always refused; where
strangers can reach the unit, nothing else keeps many addresses that ask from taking all connections. Each of these sets
warning bit 9 for 10 s. The log counts them, and connections that were closed for one of the limits above, in one line
each 10 s at most. Keep one connection and poll it, rather than one connection for each request; when it was closed,
connect anew.
"""


def page(register_map: RegisterMap) -> str:
    """The whole page."""
    places = {
        "major": register_map.major,
        "minor": register_map.minor,
        "last": register_map.image_length - 1,
        "mirror": register_map.mirror_at,
        "mirror_last": register_map.mirror_at + register_map.image_length - 1,
    }
    server = register_map.server
    connections = CONNECTIONS.format(**asdict(server), burst=1000 * server.burst_ms // server.pace_us)
    parts = [INTRODUCTION.format(**places), CLIENT.format(**places), connections]
    parts += [_block(block) for block in register_map.blocks]
    parts += [_names(f"Bits: {name}", "bit", rows) for name, rows in register_map.bits.items()]
    parts += [_names(f"Numbers: {name}", "number", rows) for name, rows in register_map.choices.items()]
    return "\n".join(parts)


def _block(block: Block) -> str:
    head = f"## {block.title}, {block.first} to {block.last}\n\n{block.text}\n\n"
    head += "| address | name | type | unit | scale | unknown | meaning | since |\n|---|---|---|---|---|---|---|---|\n"
    return head + "".join(_row(block, register) for register in block.registers)


def _row(block: Block, register: Register) -> str:
    address = str(register.address) if register.words == 1 else f"{register.address}-{_end(register)}"
    meaning = register.meaning.replace("|", "\\|")
    if register.repeat > 1:
        meaning += f"; {register.repeat} times, every {register.stride} registers"
    for table in (register.bits, register.choices):
        if table is not None:
            meaning += f" ([{table}](#{'bits' if register.bits else 'numbers'}-{table}))"
    cells = [address, f"`{block.name}.{register.name}`", register.type, register.unit, _scale(register)]
    return "| " + " | ".join([*cells, _unknown(register), meaning, register.since]) + " |\n"


def _end(register: Register) -> int:
    return register.address + register.words - 1


def _scale(register: Register) -> str:
    return "" if register.scale == 1 else f"{register.scale:g}"


def _unknown(register: Register) -> str:
    if register.unknown is None:
        return ""
    return "NaN" if isinstance(register.unknown, str) else f"0x{register.unknown:0{4 * register.words}X}"


def _names(title: str, column: str, rows: tuple[Name, ...]) -> str:
    head = f"## {title}\n\n| {column} | name | meaning |\n|---|---|---|\n"
    return head + "".join(f"| {row.value} | {row.name} | {row.meaning} |\n" for row in rows)
