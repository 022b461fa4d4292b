"""The Modbus clients of TwinCAT, CODESYS and TIA Portal as far as a program sees them: inputs, outputs, and when they
change. A request takes some cycles; what it read stands in the program's `words` before the client says so."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from host_tool.errors import DeviceError
from structured_text.execution import Runtime
from structured_text.plc import Wire, shipped_program
from structured_text.program import Program, program_from
from structured_text.values import Structure, Value

# `over` and `bad` are set from outside, as the network would.
EDGE = """
FUNCTION_BLOCK {name}
VAR_INPUT
    {inputs}
END_VAR
VAR_OUTPUT
    {busy} : BOOL; {done} : BOOL; {error} : BOOL;
END_VAR
VAR
    over : BOOL; bad : BOOL; before : BOOL;
END_VAR
{reset}
IF {execute} AND NOT before THEN
    {busy} := TRUE; {done} := FALSE; {error} := FALSE; over := FALSE;
ELSIF {busy} AND over THEN
    {busy} := FALSE; {done} := NOT bad; {error} := bad; over := FALSE;
END_IF;
before := {execute};
END_FUNCTION_BLOCK
"""
KEEPS = ""  # TwinCAT: outputs stay until the next start
FALLS = "IF NOT {execute} THEN {done} := FALSE; {error} := FALSE; {busy} := FALSE; END_IF;"  # CODESYS
PULSES = "{done} := FALSE; {error} := FALSE;"  # TIA Portal: for one call


def client_text(name: str, inputs: str, names: dict[str, str], reset: str) -> str:
    """One client block; `names` are its execute, busy, done and error."""
    return EDGE.format(name=name, inputs=inputs, reset=reset.format(**names), **names)


BECKHOFF = {"execute": "bExecute", "busy": "bBusy", "done": "hidden", "error": "bError"}
CODESYS = {"execute": "xExecute", "busy": "xBusy", "done": "xDone", "error": "xError"}
SIEMENS = {"execute": "REQ", "busy": "BUSY", "done": "DONE", "error": "ERROR"}
CLIENTS = {
    "Beckhoff": client_text(
        "FB_MBReadRegs",
        "nTCPPort, nQuantity, nMBAddr : WORD; bExecute : BOOL; tTimeout : TIME;",
        BECKHOFF,
        KEEPS,
    )
    + client_text(
        "FB_MBWriteSingleReg",
        "nTCPPort, nMBAddr, nValue : WORD; bExecute : BOOL; tTimeout : TIME;",
        BECKHOFF,
        KEEPS,
    ),
    "CODESYS": "FUNCTION_BLOCK ClientTCP\nVAR_INPUT\n xConnect : BOOL;\nEND_VAR\nVAR_OUTPUT\n xError : BOOL;\nEND_VAR\n"
    "xError := FALSE;\nEND_FUNCTION_BLOCK\n"
    + client_text(
        "ClientRequestReadHoldingRegisters",
        "uiUnitId, uiStartItem, uiQuantity : UINT; udiReplyTimeout : UDINT; xExecute : BOOL;",
        CODESYS,
        FALLS,
    )
    + client_text(
        "ClientRequestWriteSingleRegister",
        "uiUnitId, uiItem, uiValue : UINT; udiReplyTimeout : UDINT; xExecute : BOOL;",
        CODESYS,
        FALLS,
    ),
    "Siemens": client_text(
        "MB_CLIENT",
        "REQ, DISCONNECT : BOOL; MB_MODE, MB_DATA_ADDR, MB_DATA_LEN : UINT;",
        SIEMENS,
        PULSES,
    ),
}
# What the network does with a client's inputs: the address, and the quantity (a reading) or the value (a writing).
REQUESTS = {
    "FB_MBReadRegs": ("nmbaddr", "nquantity", ""),
    "FB_MBWriteSingleReg": ("nmbaddr", "", "nvalue"),
    "ClientRequestReadHoldingRegisters": ("uistartitem", "uiquantity", ""),
    "ClientRequestWriteSingleRegister": ("uiitem", "", "uivalue"),
}
BUSY, IDLE = ("bbusy", "xbusy", "busy"), Value("BOOL", False)
SIEMENS_FRAME = """FUNCTION_BLOCK Robot
VAR
    unit : TripointUnit; limits : TripointLimits; words : ARRAY[0..115] OF WORD; command : WORD; client : MB_CLIENT;
END_VAR
{body}END_FUNCTION_BLOCK
"""


def program_text(vendor: str, shown: str) -> str:
    """The guide's program as a block that can be run: pointers, texts and library names are taken out."""
    text = SIEMENS_FRAME.format(body=shown) if vendor == "Siemens" else shown
    text = text.replace("PROGRAM Robot", "FUNCTION_BLOCK Robot").replace("END_PROGRAM", "END_FUNCTION_BLOCK")
    text = re.sub(
        r"\b(sIPAddr|cbLength|pDestAddr|pData|rClient|MB_DATA_PTR|CONNECT) := [^,;]*?(\([a-z]+\))?(?=[,)])", "", text
    )
    text = re.sub(r",\s*(?=[,)])", "", text)
    text = re.sub(r"\(\s*,\s*", "(", text)
    text = re.sub(r"ModbusFB\.(\w+)( := \(.*?\))?;", r"\1;", text)
    text = text.replace("nTCPPort := 502", "nTCPPort := 16#01F6").replace("    VAR", "VAR")
    text = re.sub(r"IF unit.live.valid THEN\s*;.*?END_IF;\n", "", text, flags=re.S)
    return text.replace("limits := limits)", "limits := limits, latch := latch)").replace(
        "VAR\n", "VAR\n    latch : BOOL;\n", 1
    )


@dataclass(slots=True)
class Controller:
    """A program of the guide with its vendor's client, before a unit."""

    vendor: str
    shown: str
    wire: Wire
    folder: Path
    takes: int = 2  # cycles of a request
    runtime: Runtime = field(init=False)
    program: Structure = field(init=False)
    waited: int = 0

    def __post_init__(self) -> None:
        file = self.folder / "robot.st"
        file.write_text(CLIENTS[self.vendor] + program_text(self.vendor, self.shown), encoding="utf-8")
        self.runtime = Runtime(Program(shipped_program().units | program_from([file]).units))
        self.program = self.runtime.instance("Robot")

    def cycle(self, latch: bool, limits: dict[str, Any]) -> None:
        """10 ms, in which the network may bring an answer."""
        members = self.program.members
        members["latch"] = Value("BOOL", latch)
        self.runtime.clock.now_ms += 10
        self._network()
        if self.vendor != "Beckhoff":  # there the guide sets them
            of = members["limits"].members
            for name, data in limits.items():
                of[name] = Value(of[name].type, data)
        self.runtime.call(self.program, {})

    def said(self, path: str) -> Any:
        """An output of the unit's block, as said("live.valid")."""
        place: Any = self.program.members["unit"]
        for name in path.split("."):
            place = place.members[name]
        return place.data

    def _network(self) -> None:
        for client in self.program.members.values():
            if not isinstance(client, Structure) or not any(client.members.get(name, IDLE).data for name in BUSY):
                continue
            self.waited += 1
            if self.waited >= self.takes:
                self.waited = 0
                client.members["over"] = Value("BOOL", True)
                client.members["bad"] = Value("BOOL", not self._carried_out(client))

    def _carried_out(self, client: Structure) -> bool:
        inputs = {name: value.data for name, value in client.members.items()}
        if client.type == "MB_CLIENT":
            address, reads = inputs["mb_data_addr"], inputs["mb_mode"] == 103
            quantity, value = inputs["mb_data_len"], self.program.members["command"].data
        else:
            place, count, what = REQUESTS[client.type]
            address, reads = inputs[place], bool(count)
            quantity, value = inputs.get(count, 0), inputs.get(what, 0)
        try:
            if reads:
                words = [Value("WORD", word) for word in self.wire.read(address, quantity)]
                self.program.members["words"].items[: len(words)] = words
            else:
                self.wire.write(address, value)
        except DeviceError:
            return False
        return True
