"""Siemens TIA Portal: data blocks as an external source. S7 memory has the most significant word first, as at 0."""

from collections.abc import Sequence

from host_tool.plc.requests import Gap, Request, Tag, command_register

TYPES = {"u16": "UInt", "i16": "Int", "u32": "UDInt", "i32": "DInt", "f32": "Real"}


def siemens(requests: Sequence[Request]) -> str:
    """One data block for each request, laid out as its answer (not optimised), for MB_DATA_PTR."""
    command = command_register().address
    head = [
        "// Tripoint, for TIA Portal: add as external source file, then generate blocks from source.",
        "// MB_CLIENT with MB_MODE 103 counts from 0, with MB_MODE 0 from 40001; MB_DATA_PTR is the data block.",
        f"// Command: MB_MODE 106, MB_DATA_ADDR {command}, or MB_MODE 1, MB_DATA_ADDR {40001 + command}; one word.",
    ]
    return "\n".join([*head, *(line for request in requests for line in _block(request))]) + "\n"


def _block(request: Request) -> list[str]:
    first = request.first
    lines = [
        "",
        f"// MB_MODE 103: MB_DATA_ADDR {first}, MB_DATA_LEN {request.count}; MB_MODE 0: MB_DATA_ADDR {40001 + first}",
        f'DATA_BLOCK "{request.title}"',
        "{ S7_Optimized_Access := 'FALSE' }",
        "VERSION : 0.1",
        "NON_RETAIN",
        "   STRUCT",
    ]
    for place in request.places():
        lines += [f"      {line}" for line in _members(place)]
    return [*lines, "   END_STRUCT;", "BEGIN", "END_DATA_BLOCK"]


def _members(place: Tag | Gap) -> list[str]:
    if isinstance(place, Gap):
        return [f"unassigned_{place.address} : Array[0..{place.count - 1}] of Word;"]
    register = place.register
    if register.type == "u64":  # an S7-1200 has no whole number of 64 bits
        return [f"{place.name}_high : UDInt;   // {place.comment}", f"{place.name}_low : UDInt;"]
    kind = "Word" if register.bits is not None else TYPES[register.type]
    return [f"{place.name} : {kind};   // {place.comment}"]
