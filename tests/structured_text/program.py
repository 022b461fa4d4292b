"""The program units of Structured Text files, read by blark's grammar, and instances of what they declare."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from blark import parse
from blark import transform as tree

from structured_text.timer import Timer
from structured_text.values import RANGES, Array, Structure, StructuredTextError, Value, negated, of_type

ZEROS: dict[str, Any] = {"BOOL": False, "LREAL": 0.0} | dict.fromkeys(RANGES, 0)
INPUTS, OUTPUTS, LOCALS, CONSTANTS = "input", "output", "local", "constant"
KINDS = {"InputDeclarations": INPUTS, "OutputDeclarations": OUTPUTS}


@dataclass(frozen=True, slots=True)
class Declaration:
    """One declared name."""

    name: str
    kind: str
    init: Any


@dataclass(frozen=True, slots=True)
class Unit:
    """A function, a function block or a structure (which has no body)."""

    name: str
    declarations: tuple[Declaration, ...]
    body: Any
    returns: str
    inputs: frozenset[str]  # in lower case
    assignable: frozenset[str]  # what its own statements may assign


@dataclass(frozen=True, slots=True)
class Program:
    """All units by name in lower case."""

    units: dict[str, Unit]

    def fresh(self, type_name: str) -> Any:
        """A value or an instance of that type, as it starts."""
        if type_name in ZEROS:
            return Value(type_name, ZEROS[type_name])
        if type_name == "TON":
            return Timer()
        unit = self.units.get(type_name.lower())
        if unit is None or unit.returns:
            raise StructuredTextError(f"there is no type {type_name}")
        return Structure(unit.name, {one.name.lower(): self.start_of(one) for one in unit.declarations})

    def start_of(self, one: Declaration) -> Any:
        """What a declared name holds at the start."""
        spec = one.init.spec
        if isinstance(one.init, tree.ArrayTypeInitialization):
            (bounds,) = spec.subranges
            first, last = int(str(bounds.start)), int(str(bounds.stop))
            element = str(spec.type)
            return Array(element, first, [self.fresh(element) for _ in range(first, last + 1)])
        type_name = str(spec.type)
        start = self.fresh(type_name)
        return start if one.init.value is None else of_type(literal_of(one.init.value), type_name)


def program_from(files: Sequence[Path]) -> Program:
    """Everything the files declare; StructuredTextError for what the grammar or the rules for names refuse."""
    units: dict[str, Unit] = {}
    for file in files:
        for result in parse.parse(file):
            if result.exception is not None:
                raise StructuredTextError(f"{file.name}: {result.exception}")
            for item in result.transform().items:
                unit = _unit_from(item)
                if unit.name.lower() in units:
                    raise StructuredTextError(f"{unit.name} exists twice")
                units[unit.name.lower()] = unit
    return Program(units)


def literal_of(node: Any) -> Value:
    """The value of a literal, also behind a minus."""
    if isinstance(node, tree.UnaryOperation) and str(node.op) == "-":
        return negated(literal_of(node.expr))
    match node:
        case tree.Boolean():
            return Value("BOOL", str(node.value).upper() == "TRUE")
        case tree.HexInteger():
            return Value("16# literal", int(str(node.value), 16))
        case tree.Integer():
            return Value("whole literal", int(str(node.value)))
        case tree.Real():
            return Value("real literal", float(str(node.value)))
        case tree.Duration():
            parts = ((node.hours, 3_600_000), (node.seconds, 1000), (node.milliseconds, 1))
            return Value("TIME", sum(int(str(part)) * ms for part, ms in parts if part is not None))
    raise StructuredTextError(f"{node} is no literal")


def nodes_of(node: Any) -> Iterator[Any]:
    """Every node of a tree below and including `node`."""
    if isinstance(node, (list, tuple)):
        for item in node:
            yield from nodes_of(item)
    elif hasattr(node, "__dataclass_fields__"):
        yield node
        for name in node.__dataclass_fields__:
            if name != "meta":
                yield from nodes_of(getattr(node, name))


def _unit_from(item: Any) -> Unit:
    match item:
        case tree.DataTypeDeclaration(declaration=tree.StructureTypeDeclaration() as structure):
            return _named(str(structure.name), tuple(_declared(structure.declarations, LOCALS)), None)
        case tree.Function() | tree.FunctionBlock():
            declarations = [one for section in item.declarations for one in _declared(section.items, _kind_of(section))]
            returns = str(item.return_type.type.type) if isinstance(item, tree.Function) else ""
            return _named(str(item.name), tuple(declarations), item.body, returns)
    raise StructuredTextError(f"{type(item).__name__} is not used here")


def _named(name: str, declarations: tuple[Declaration, ...], body: Any, returns: str = "") -> Unit:
    seen: set[str] = set()
    for one in declarations:
        if one.name.lower() in seen:
            raise StructuredTextError(f"{name}.{one.name} exists twice: names differ by more than capitals")
        seen.add(one.name.lower())
    inputs = frozenset(one.name.lower() for one in declarations if one.kind == INPUTS)
    assignable = {one.name.lower() for one in declarations if one.kind in (LOCALS, OUTPUTS)} | {name.lower()}
    return Unit(name, declarations, body, returns, inputs, frozenset(assignable))


def _kind_of(section: Any) -> str:
    if section.attrs is not None and "constant" in str(section.attrs).lower():
        return CONSTANTS
    return KINDS.get(type(section).__name__, LOCALS)


def _declared(items: Sequence[Any], kind: str) -> Iterator[Declaration]:
    for item in items:
        for variable in item.variables:
            yield Declaration(str(getattr(variable.variable, "name", variable.variable)), kind, item.init)
