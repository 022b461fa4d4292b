"""Runs Structured Text: one call of a function block or a function, statement by statement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from blark import transform as tree

from structured_text.program import Program, Unit, literal_of
from structured_text.timer import Clock, Timer
from structured_text.values import (
    Array,
    Structure,
    StructuredTextError,
    Value,
    complement,
    converted,
    negated,
    of_type,
    operation,
    stored,
)

Scope = dict[str, Any]


@dataclass(slots=True)
class Runtime:
    """A PLC: its program, its clock, and which statements have run (by node)."""

    program: Program
    clock: Clock = field(default_factory=Clock)
    run_nodes: set[int] = field(default_factory=set)

    def instance(self, type_name: str) -> Structure:
        """A new instance of a function block or structure."""
        made = self.program.fresh(type_name)
        if not isinstance(made, Structure):
            raise StructuredTextError(f"{type_name} has no instances")
        return made

    def call(self, block: Structure, inputs: Mapping[str, Any]) -> None:
        """One call of a function block; inputs that are not named keep their value."""
        unit = self.program.units[block.type.lower()]
        for name, value in inputs.items():
            if name not in unit.inputs:
                raise StructuredTextError(f"{unit.name} has no input {name}")
            block.members[name] = stored(value, block.members[name])
        self._run(unit.body.statements, block.members, unit)

    def result_of(self, function: str, inputs: Mapping[str, Any]) -> Any:
        """What a function returns; all its inputs must be named."""
        unit = self.program.units[function.lower()]
        scope = {one.name.lower(): self.program.start_of(one) for one in unit.declarations}
        if inputs.keys() != unit.inputs:
            raise StructuredTextError(f"{unit.name} takes {sorted(unit.inputs)}, not {sorted(inputs)}")
        for name, value in inputs.items():
            scope[name] = stored(value, scope[name])
        scope[unit.name.lower()] = self.program.fresh(unit.returns)
        self._run(unit.body.statements, scope, unit)
        return scope[unit.name.lower()]

    def _run(self, statements: Sequence[Any], scope: Scope, unit: Unit) -> None:
        for statement in statements:
            self.run_nodes.add(id(statement))
            try:
                self._statement(statement, scope, unit)
            except StructuredTextError as error:
                line = getattr(getattr(statement, "meta", None), "line", "?")
                raise StructuredTextError(f"{unit.name}, line {line}: {error}") from None

    def _statement(self, statement: Any, scope: Scope, unit: Unit) -> None:
        match statement:
            case tree.AssignmentStatement():
                value = self.value(statement.expression, scope)
                for variable in statement.variables:
                    self._assign(variable, value, scope, unit)
            case tree.FunctionCallStatement():
                self._call_of(statement, scope)
            case tree.IfStatement():
                self._run(self._branch(statement, scope), scope, unit)
            case tree.CaseStatement():
                self._run(self._case(statement, scope), scope, unit)
            case tree.ForStatement():
                self._for(statement, scope, unit)
            case _:
                raise StructuredTextError(f"{type(statement).__name__} is not used here")

    def _call_of(self, statement: Any, scope: Scope) -> None:
        block = scope[str(statement.name).lower()]
        inputs = self._inputs(statement, scope)
        if isinstance(block, Timer):
            for name, value in inputs.items():
                block.members[name] = stored(value, block.members[name])
            block.run(self.clock)
        else:
            self.call(block, inputs)

    def _inputs(self, call: Any, scope: Scope) -> dict[str, Any]:
        return {str(one.name).lower(): self.value(one.value, scope) for one in call.parameters}

    def _branch(self, statement: Any, scope: Scope) -> Sequence[Any]:
        clauses = [(statement.if_expression, statement.statements)]
        clauses += [(clause.if_expression, clause.statements) for clause in statement.else_ifs]
        for condition, body in clauses:
            if of_type(self.value(condition, scope), "BOOL").data:
                return _statements(body)
        return _statements(statement.else_clause.statements) if statement.else_clause else ()

    def _case(self, statement: Any, scope: Scope) -> Sequence[Any]:
        selector = self.value(statement.expression, scope)
        for case in statement.cases:
            for match in case.matches:
                name = str(getattr(match, "name", "")).lower()
                label = scope[name] if name in scope else literal_of(match)
                if operation("=", selector, label).data:
                    return _statements(case.statements)
        return _statements(statement.else_clause.statements) if statement.else_clause else ()

    def _for(self, statement: Any, scope: Scope, unit: Unit) -> None:
        control = str(statement.control).lower()
        first, last = (self.value(end, scope) for end in (statement.from_, statement.to))
        for i in range(first.data, last.data + 1):
            scope[control] = of_type(Value(first.type, i), scope[control].type)
            self._run(_statements(statement.statements), scope, unit)

    def _assign(self, variable: Any, value: Any, scope: Scope, unit: Unit) -> None:
        name = str(variable.name if isinstance(variable, tree.MultiElementVariable) else variable).lower()
        if name not in unit.assignable:
            raise StructuredTextError(f"{name} cannot be assigned")
        if isinstance(variable, tree.SimpleVariable):
            scope[name] = stored(value, scope[name])
            return
        holder, last = scope[name], variable.elements[-1]
        for element in variable.elements[:-1]:
            holder = self._element(holder, element, scope)
        if isinstance(last, tree.FieldSelector):
            field_name = str(last.field).lower()
            holder.members[field_name] = stored(value, self._element(holder, last, scope))
        else:
            place = self._element(holder, last, scope)
            holder.items[self._index(holder, last, scope)] = stored(value, place)

    def value(self, node: Any, scope: Scope) -> Any:
        """What an expression is."""
        match node:
            case tree.BinaryOperation():
                return operation(str(node.op).upper(), self.value(node.left, scope), self.value(node.right, scope))
            case tree.UnaryOperation():
                operand = self.value(node.expr, scope)
                return complement(operand) if str(node.op).upper() == "NOT" else negated(operand)
            case tree.ParenthesizedExpression():
                return self.value(node.expr, scope)
            case tree.FunctionCall():
                return self._function(node, scope)
            case tree.SimpleVariable() | tree.MultiElementVariable():
                return self._variable(node, scope)
        return literal_of(node)

    def _variable(self, node: Any, scope: Scope) -> Any:
        if isinstance(node, tree.SimpleVariable):
            return _named(str(node), scope)
        holder = _named(str(node.name), scope)
        for element in node.elements:
            holder = self._element(holder, element, scope)
        return holder

    def _function(self, node: Any, scope: Scope) -> Any:
        name = str(node.name)
        if name.lower() in self.program.units:
            return self.result_of(name, self._inputs(node, scope))
        (argument,) = node.parameters
        result = converted(name, self.value(argument.value, scope))
        if result is None:
            raise StructuredTextError(f"there is no function {name}")
        return result

    def _element(self, holder: Any, element: Any, scope: Scope) -> Any:
        if isinstance(element, tree.FieldSelector):
            return _named(str(element.field), holder.members)
        return holder.items[self._index(holder, element, scope)]

    def _index(self, holder: Any, element: Any, scope: Scope) -> int:
        (subscript,) = element.subscripts
        index: int = of_type(self.value(subscript, scope), "INT").data - holder.first
        if not isinstance(holder, Array) or not 0 <= index < len(holder.items):
            raise StructuredTextError(f"index {index + holder.first} is outside the array")
        return index


def _named(name: str, scope: Scope) -> Any:
    if name.lower() not in scope:
        raise StructuredTextError(f"there is no {name}")
    return scope[name.lower()]


def _statements(body: Any) -> Sequence[Any]:
    return () if body is None else body.statements
