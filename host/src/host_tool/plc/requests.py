"""The requests by which a client reads the map: each one answer, so that what is in it belongs together."""

from collections.abc import Iterator
from dataclasses import dataclass

from host_tool.contract.register_map import Register, RegisterMap, register_map

MAX_WORDS = 125  # of one request, by the Modbus specification
BLOCKS_OF = {
    "identity": ("identity",),
    "pose": ("state", "measured"),
    "pose_float": ("measured_float",),
    "predicted": ("predicted",),
    "single": ("single",),
    "latched": ("latched",),
    "latched_single": ("latched_single",),
    "points": ("points",),
    "health": ("left_camera", "right_camera", "timing"),
}
COMMAND = "command"  # the one register that is written


@dataclass(frozen=True, slots=True)
class Tag:
    """One value of an answer; `name` is unique among all requests."""

    name: str
    register: Register
    offset: int  # of its first register in the answer

    @property
    def comment(self) -> str:
        """Address, unit and meaning in one line of ASCII without quotes, which no import chokes on."""
        register = self.register
        unit = f", {register.unit}" if register.unit else ""
        scale = f" x {register.scale:.9f}".rstrip("0").rstrip(".") if register.scale != 1 else ""
        return f"{register.address}{unit}{scale}: {register.meaning}".replace('"', "").replace("'", "")


@dataclass(frozen=True, slots=True)
class Gap:
    """Registers of an answer that are not assigned."""

    address: int
    offset: int
    count: int


@dataclass(frozen=True, slots=True)
class Request:
    """One reading: `count` registers from `first`, counted from 0."""

    name: str
    first: int
    count: int
    tags: tuple[Tag, ...]

    @property
    def title(self) -> str:
        """Its name as one word with capitals, for tools that want it so."""
        return "Tripoint" + "".join(part.capitalize() for part in self.name.split("_"))

    def places(self) -> Iterator[Tag | Gap]:
        """Tags and gaps without a hole, by offset."""
        at = 0
        for tag in self.tags:
            if tag.offset > at:
                yield Gap(self.first + at, at, tag.offset - at)
            yield tag
            at = tag.offset + tag.register.count
        if at < self.count:
            yield Gap(self.first + at, at, self.count - at)


def requests(names: tuple[str, ...] = ()) -> tuple[Request, ...]:
    """Those named, or all of them, by address."""
    return tuple(_request(name, register_map()) for name in BLOCKS_OF if name in names or not names)


def command_register() -> Register:
    """The register that commands are written to."""
    return register_map().blocks[COMMAND].registers["word"]


def _request(name: str, known: RegisterMap) -> Request:
    blocks = [known.blocks[block] for block in BLOCKS_OF[name]]
    first, last = blocks[0].first, blocks[-1].last
    tags = [
        Tag(f"{block.name}_{register.name}", register, register.address - first)
        for block in blocks
        for register in sorted(block.registers.values(), key=lambda register: register.address)
    ]
    return Request(name, first, last - first + 1, tuple(tags))
