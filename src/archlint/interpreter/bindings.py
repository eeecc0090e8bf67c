"""Which names a function binds: what Python's compiler decides before the function runs."""

from __future__ import annotations

from collections.abc import Iterable

from archlint.syntax import facts
from archlint.syntax.parts import once_for
from archlint.syntax.walk import statements_of


def bound_in(block: list[facts.Stmt]) -> frozenset[str]:
    """The names that a block of statements binds, those of the functions inside it left out."""
    names: set[str] = set()
    _of_block(block, names, set())
    return frozenset(names)


@once_for
def bound_names(ir: facts.Function | facts.Lambda) -> tuple[frozenset[str], frozenset[str]]:
    """The local names of a function, and those it declares ``global`` or ``nonlocal``."""
    names = {param.name for param in ir.params}
    outer: set[str] = set()
    if isinstance(ir, facts.Function):
        _of_block(ir.body, names, outer)
    else:
        _of_expression(ir.body, names)
    return frozenset(names - outer), frozenset(outer)


def _of_block(block: list[facts.Stmt], names: set[str], outer: set[str]) -> None:
    for statement in statements_of(block):
        _of_statement(statement, names, outer)


def _of_statement(s: facts.Stmt, names: set[str], outer: set[str]) -> None:
    """What a statement itself binds, its blocks left out."""
    names.update(_named(s))
    for target in _targets(s):
        _of_target(target, names)
    _of_expression(_evaluated(s), names)
    match s:
        case facts.Match():
            for case in s.cases:
                _of_pattern(case.pattern, names)
        case facts.Global():
            outer.update(s.names)


def _named(s: facts.Stmt) -> Iterable[str]:
    """The names that a statement says itself."""
    match s:
        case facts.Function() | facts.Class():
            return [s.name]
        case facts.Try():
            return [handler.name for handler in s.handlers if handler.name is not None]
        case facts.Import():
            return [s.alias or s.module.partition(".")[0]]
        case facts.ImportFrom():
            return [bound for _, bound in s.names if bound != "*"]
    return ()


def _targets(s: facts.Stmt) -> Iterable[facts.Expr]:
    """What a statement assigns to."""
    match s:
        case facts.Assign():
            return s.targets
        case facts.Annotated() | facts.Augmented() | facts.For():
            return [s.target]
        case facts.With():
            return [item.target for item in s.items if item.target is not None]
    return ()


def _evaluated(s: facts.Stmt) -> facts.Expr | None:
    """The expression of a statement in which a ``:=`` can occur in practice."""
    match s:
        case facts.Assign() | facts.Annotated() | facts.Augmented() | facts.Expression() | facts.Return():
            return s.value
        case facts.If() | facts.While() | facts.Assert():
            return s.test
    return None


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
    """Names bound by ``:=``; only where one can occur in practice."""
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
