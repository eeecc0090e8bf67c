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
    for s in block:
        if isinstance(s, facts.Assign):
            for target in s.targets:
                _of_target(target, names)
            _of_expression(s.value, names)
        elif isinstance(s, (facts.Annotated, facts.Augmented)):
            _of_target(s.target, names)
            if s.value is not None:
                _of_expression(s.value, names)
        elif isinstance(s, (facts.Function, facts.Class)):
            names.add(s.name)
        elif isinstance(s, (facts.If, facts.While)):
            _of_expression(s.test, names)
            _of_block(s.body, names, outer)
            _of_block(s.orelse, names, outer)
        elif isinstance(s, facts.For):
            _of_target(s.target, names)
            _of_block(s.body, names, outer)
            _of_block(s.orelse, names, outer)
        elif isinstance(s, facts.With):
            for item in s.items:
                if item.target is not None:
                    _of_target(item.target, names)
            _of_block(s.body, names, outer)
        elif isinstance(s, facts.Try):
            for part in (s.body, s.orelse, s.final):
                _of_block(part, names, outer)
            for handler in s.handlers:
                if handler.name is not None:
                    names.add(handler.name)
                _of_block(handler.body, names, outer)
        elif isinstance(s, facts.Match):
            for case in s.cases:
                _of_pattern(case.pattern, names)
                _of_block(case.body, names, outer)
        elif isinstance(s, facts.Import):
            names.add(s.alias or s.module.partition(".")[0])
        elif isinstance(s, facts.ImportFrom):
            names.update(bound for _, bound in s.names if bound != "*")
        elif isinstance(s, facts.Global):
            outer.update(s.names)
        elif isinstance(s, (facts.Expression, facts.Return, facts.Assert)):
            value = s.test if isinstance(s, facts.Assert) else s.value
            if value is not None:
                _of_expression(value, names)


def _of_target(target: facts.Expr, names: set[str]) -> None:
    if isinstance(target, facts.Name):
        names.add(target.id)
    elif isinstance(target, facts.Sequence):
        for element in target.elements:
            _of_target(element, names)
    elif isinstance(target, facts.Starred):
        _of_target(target.value, names)


def _of_pattern(pattern: facts.Pattern, names: set[str]) -> None:
    if pattern.name is not None:
        names.add(pattern.name)
    for part in pattern.parts:
        _of_pattern(part, names)


def _of_expression(e: facts.Expr, names: set[str]) -> None:
    """Names bound by ``:=``; only where one can stand in practice."""
    if isinstance(e, facts.Assigned):
        _of_target(e.target, names)
        _of_expression(e.value, names)
    elif isinstance(e, facts.Boolean):
        for value in e.values:
            _of_expression(value, names)
    elif isinstance(e, facts.Compare):
        _of_expression(e.left, names)
        for value in e.comparators:
            _of_expression(value, names)
    elif isinstance(e, facts.Unary):
        _of_expression(e.operand, names)
    elif isinstance(e, facts.Call):
        for argument in e.args:
            _of_expression(argument.value, names)
    elif isinstance(e, facts.Await):
        _of_expression(e.value, names)
