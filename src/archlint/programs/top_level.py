"""What stands at the top level of a module: its main guard, its definitions."""

from __future__ import annotations

from archlint.finding import Place
from archlint.interpreter.values import ClassValue, FunctionValue, Value
from archlint.syntax import facts


def called_alone(body: list[facts.Stmt]) -> list[str] | None:
    """The functions that a block calls without arguments, where it does nothing else."""
    names = []
    for statement in body:
        match statement:
            case facts.Expression(facts.Call(facts.Name(name), [])):
                names.append(name)
            case _:
                return None
    return names


def definitions(body: list[facts.Stmt]) -> list[facts.Function | facts.Class]:
    """The functions and classes of a block, those under a condition too."""
    statements: list[facts.Function | facts.Class] = []
    for statement in body:
        match statement:
            case facts.Function() | facts.Class():
                statements.append(statement)
            case facts.If() | facts.Try():
                statements += [*definitions(statement.body), *definitions(statement.orelse)]
    return statements


def place_of(value: Value) -> Place | None:
    """Where a class or a function is defined."""
    if isinstance(value, (ClassValue, FunctionValue)):
        span = value.ir.span if isinstance(value.ir, facts.Lambda) else value.ir.name_span
        return Place(value.scope.module.path, *span)
    return None


__all__ = ["called_alone", "definitions", "place_of"]
