"""Rockwell Studio 5000: tags as CSV. Logix memory has the least significant word first, like the image at 2000."""

from collections.abc import Sequence

from host_tool.contract.register_map import Register, register_map
from host_tool.plc.requests import Request, Tag, command_register

WIDE_TYPES = {"u32": "DINT", "i32": "DINT", "f32": "REAL", "u64": "LINT"}
HEADER = "TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER"
UNKNOWN_IS_NEGATIVE = "; negative here = unknown or too large: never a small number"


def rockwell(requests: Sequence[Request]) -> str:
    """An INT array for each request, an alias for each single register, and a tag to copy each wide value to.

    Many controllers know signed numbers alone: what that makes of a large unsigned one is in its description.
    """
    lines = [
        'remark,"CSV-Import-Export"',
        'remark,"Tripoint: Tools, Import, Tags and Logic Comments"',
        f'remark,"Command: holding register {command_register().address}, counted from 0, function 6"',
        "0.3",
        HEADER,
    ]
    for request in requests:
        first = request.first + register_map().mirror_at
        reading = f"function 3 from {first}, counted from 0; {request.count} registers"
        lines.append(f'TAG,,{request.title},"{reading}","INT[{request.count}]",""')
        lines += [_line(request, tag) for tag in request.tags]
    return "\n".join(lines) + "\n"


def _line(request: Request, tag: Tag) -> str:
    name, source = f"Tripoint_{tag.name}", f"{request.title}[{tag.offset}]"
    comment = tag.comment + _sign_note(tag.register)
    if tag.register.count == 1:
        return f'ALIAS,,{name},"{comment}","","{source}"'
    return f'TAG,,{name},"COP({source},{name},1); {comment}","{WIDE_TYPES[tag.register.type]}",""'


def _sign_note(register: Register) -> str:
    """What a client that knows signed numbers alone must know of an unsigned one."""
    if not register.type.startswith("u") or register.bits is not None:
        return ""
    return UNKNOWN_IS_NEGATIVE if register.unknown is not None else f"; negative here: add {1 << 16 * register.count}"
