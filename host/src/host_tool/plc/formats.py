"""Which tools the map can be written for."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from host_tool.plc.listing import listing
from host_tool.plc.requests import BLOCKS_OF, Request, requests
from host_tool.plc.rockwell import rockwell
from host_tool.plc.siemens import siemens
from host_tool.plc.structured_text import beckhoff, codesys
from host_tool.plc.universal_robots import universal_robots


@dataclass(frozen=True, slots=True)
class Format:
    """One tool; `write` takes the requests and the unit's host."""

    name: str
    ending: str
    tool: str
    write: Callable[[Sequence[Request], str], str]
    usual: tuple[str, ...] = ()  # the requests that are written when none is named: empty = all


FORMATS = {
    one.name: one
    for one in (
        Format("csv", "csv", "any: all values, with their addresses in each way of counting", lambda r, _: listing(r)),
        Format("siemens", "scl", "TIA Portal: data blocks, as external source", lambda r, _: siemens(r)),
        Format("beckhoff", "st", "TwinCAT 3: structures for addresses from 2000", lambda r, _: beckhoff(r)),
        Format("codesys", "st", "CODESYS 3.5: structures for addresses from 2000", lambda r, _: codesys(r)),
        Format(
            "rockwell", "csv", "Studio 5000: tags, as CSV import, for addresses from 2000", lambda r, _: rockwell(r)
        ),
        Format(
            "ur",
            "script",
            "Universal Robots: Modbus signals, as URScript",
            universal_robots,
            ("pose", "latched_single"),
        ),
    )
}
REQUEST_NAMES = tuple(BLOCKS_OF)


def text_of(form: Format, names: tuple[str, ...], host: str) -> str:
    """The file for a tool, of the requests named."""
    return form.write(requests(names or form.usual), host)
