"""A name that a launch file in Python reads and nothing defines: a NameError before anything is started."""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.walk import statements_of

_ALWAYS = frozenset(dir(builtins)) | {"__file__", "__name__", "__doc__", "__package__", "__spec__", "__loader__"}
_LATER = (facts.Lambda, facts.Comprehension, facts.Yield, facts.Await)
"""Parts that run later, or whose names are their own."""


def undefined_name(found: facts.Facts, function: str) -> facts.Name | None:
    """The first name that a module, or a ``function`` of it, surely reads and that no line of the file binds."""
    every = list(_every(found.body))
    if any(isinstance(one, facts.Opaque) or (isinstance(one, facts.ImportFrom) and _takes_all(one)) for one in every):
        return None
    bound = _ALWAYS.union(*(_bound_by(one) for one in every))
    if any(isinstance(one, facts.Name) and one.id in _MAKES_NAMES for one in every):
        return None
    bodies = [found.body, *(one.body for one in found.body if isinstance(one, facts.Function) and one.name == function)]
    return next((name for body in bodies for name in _read(body) if name.id not in bound), None)


_MAKES_NAMES = frozenset({"exec", "globals", "vars", "setattr"})


def _takes_all(one: facts.ImportFrom) -> bool:
    return any(name == "*" for name, _ in one.names)


def _every(item: object) -> Iterator[object]:
    """Every part of a file, functions in functions included."""
    stack = [item]
    while stack:
        one = stack.pop()
        if isinstance(one, (list, tuple)):
            stack.extend(one)
        elif isinstance(one, facts.Base):
            yield one
            stack.extend(getattr(one, name) for name in one.__struct_fields__)


def _bound_by(one: object) -> set[str]:
    """The names that a part binds, in whichever scope."""
    if isinstance(one, (facts.Function, facts.Class, facts.Param)):
        return {one.name}
    if isinstance(one, (facts.Handler, facts.Pattern)):
        return set() if one.name is None else {one.name}
    if isinstance(one, facts.Import):
        return {one.alias or one.module.partition(".")[0]}
    if isinstance(one, facts.ImportFrom):
        return {bound for _, bound in one.names}
    if isinstance(one, facts.Global):
        return set(one.names)
    targets: Sequence[object] = one.targets if isinstance(one, facts.Assign) else [getattr(one, "target", None)]
    return {part.id for part in _every(list(targets)) if isinstance(part, facts.Name)}


def _read(body: Sequence[facts.Stmt]) -> Iterator[facts.Name]:
    """The names that a body reads whatever happens, as far as that is certain."""
    for statement in body:
        if isinstance(statement, (facts.Assign, facts.Annotated, facts.Augmented, facts.Expression, facts.Return)):
            yield from _names(statement.value)
        elif isinstance(statement, facts.If):
            yield from _names(statement.test)
        elif isinstance(statement, facts.For):
            yield from _names(statement.iterable)
        ends = (facts.Return, facts.Raise)
        if any(isinstance(inner, ends) for inner in statements_of([statement])):
            return


def _names(value: facts.Expr | None) -> Iterator[facts.Name]:
    """The names in an expression that are looked up whenever it is evaluated, in the order of the source."""
    stack: list[object] = [value]
    while stack:
        one = stack.pop()
        if isinstance(one, facts.Name):
            yield one
        elif isinstance(one, facts.Conditional):
            stack.append(one.test)
        elif isinstance(one, facts.Boolean):
            stack.append(one.values[0])
        elif isinstance(one, (list, tuple)):
            stack.extend(reversed(one))
        elif isinstance(one, facts.Base) and not isinstance(one, _LATER):
            stack.extend(getattr(one, name) for name in reversed(one.__struct_fields__))
