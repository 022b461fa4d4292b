"""TwinCAT and CODESYS: structures for memory that has the least significant word first, as the image at 2000."""

from collections.abc import Sequence

from host_tool.contract.register_map import register_map
from host_tool.plc.requests import Gap, Request, Tag, command_register

TYPES = {"u16": "UINT", "i16": "INT", "u32": "UDINT", "i32": "DINT", "f32": "REAL", "u64": "ULINT"}
BECKHOFF = "FB_MBReadRegs (TF6250): nMBAddr {first}, nQuantity {count}, pDestAddr and cbLength of a {title}"
CODESYS = "ClientRequestReadHoldingRegisters (ModbusFB): uiStartItem {first}, uiQuantity {count}, pData of a {title}"


def beckhoff(requests: Sequence[Request]) -> str:
    """For TwinCAT 3."""
    return _text(requests, "TwinCAT 3: add a DUT for each TYPE and paste it.", BECKHOFF)


def codesys(requests: Sequence[Request]) -> str:
    """For CODESYS 3.5."""
    return _text(requests, "CODESYS 3.5: add a DUT for each TYPE and paste it.", CODESYS)


def _text(requests: Sequence[Request], head: str, reading: str) -> str:
    lines = [
        f"// Tripoint, for {head}",
        f"// Command: holding register {command_register().address}, counted from 0, written with function 6.",
        "// Test the status bits before a REAL: what is not valid is NaN, which stops some runtimes when compared.",
    ]
    for request in requests:
        first = request.first + register_map().mirror_at
        lines += ["", "// " + reading.format(first=first, count=request.count, title=request.title)]
        lines += ["{attribute 'pack_mode' := '1'}", f"TYPE {request.title} :", "STRUCT"]
        lines += [f"    {_member(place)}" for place in request.places()]
        lines += ["END_STRUCT", "END_TYPE"]
    return "\n".join(lines) + "\n"


def _member(place: Tag | Gap) -> str:
    if isinstance(place, Gap):
        return f"unassigned_{place.address} : ARRAY[0..{place.count - 1}] OF WORD;"
    kind = "WORD" if place.register.bits is not None else TYPES[place.register.type]
    return f"{place.name} : {kind};  // {place.comment}"
