"""Which names a function binds: what Python's compiler decides before the function runs."""

from __future__ import annotations

from functools import lru_cache

from archlint.syntax import facts
from archlint.syntax.parts import Itself


def bound_in(block: list[facts.Stmt]) -> frozenset[str]:
    """The names that a block of statements binds, those of the functions inside it left out."""
    names: set[str] = set()
    _of_block(block, names, set())
    return frozenset(names)


def bound_names(ir: facts.Function | facts.Lambda) -> tuple[frozenset[str], frozenset[str]]:
    """The local names of a function, and those it declares ``global`` or ``nonlocal``."""
    return _bound_names(Itself(ir))


@lru_cache(maxsize=20_000)
def _bound_names(key: Itself[facts.Function | facts.Lambda]) -> tuple[frozenset[str], frozenset[str]]:
    ir = key.fact
    names = {param.name for param in ir.params}
    outer: set[str] = set()
    if isinstance(ir, facts.Function):
        _of_block(ir.body, names, outer)
    else:
        _of_expression(ir.body, names)
    return frozenset(names - outer), frozenset(outer)


def _of_block(block: list[facts.Stmt], names: set[str], outer: set[str]) -> None:
    for statement in block:
        _of_statement(statement, names, outer)


def _of_statement(s: facts.Stmt, names: set[str], outer: set[str]) -> None:
    match s:
        case facts.Assign():
            for target in s.targets:
                _of_target(target, names)
            _of_expression(s.value, names)
        case facts.Annotated() | facts.Augmented():
            _of_target(s.target, names)
            _of_expression(s.value, names)
        case facts.Function() | facts.Class():
            names.add(s.name)
        case facts.If() | facts.While():
            _of_expression(s.test, names)
            _of_block(s.body, names, outer)
            _of_block(s.orelse, names, outer)
        case facts.For():
            _of_target(s.target, names)
            _of_block(s.body, names, outer)
            _of_block(s.orelse, names, outer)
        case facts.With():
            for item in s.items:
                if item.target is not None:
                    _of_target(item.target, names)
            _of_block(s.body, names, outer)
        case facts.Try():
            for part in (s.body, s.orelse, s.final, *(handler.body for handler in s.handlers)):
                _of_block(part, names, outer)
            names.update(handler.name for handler in s.handlers if handler.name is not None)
        case facts.Match():
            for case in s.cases:
                _of_pattern(case.pattern, names)
                _of_block(case.body, names, outer)
        case facts.Import():
            names.add(s.alias or s.module.partition(".")[0])
        case facts.ImportFrom():
            names.update(bound for _, bound in s.names if bound != "*")
        case facts.Global():
            outer.update(s.names)
        case facts.Expression() | facts.Return():
            _of_expression(s.value, names)
        case facts.Assert():
            _of_expression(s.test, names)


def _of_target(target: facts.Expr, names: set[str]) -> None:
    match target:
        case facts.Name():
            names.add(target.id)
        case facts.Sequence():
            for element in target.elements:
                _of_target(element, names)
        case facts.Starred():
            _of_target(target.value, names)


def _of_pattern(pattern: facts.Pattern, names: set[str]) -> None:
    if pattern.name is not None:
        names.add(pattern.name)
    for part in pattern.parts:
        _of_pattern(part, names)


def _of_expression(e: facts.Expr | None, names: set[str]) -> None:
    """Names bound by ``:=``; only where one can stand in practice."""
    match e:
        case facts.Assigned():
            _of_target(e.target, names)
            _of_expression(e.value, names)
        case facts.Boolean():
            for value in e.values:
                _of_expression(value, names)
        case facts.Compare():
            for value in (e.left, *e.comparators):
                _of_expression(value, names)
        case facts.Unary():
            _of_expression(e.operand, names)
        case facts.Call():
            for argument in e.args:
                _of_expression(argument.value, names)
        case facts.Await():
            _of_expression(e.value, names)
