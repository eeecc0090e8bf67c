"""Which names a part of Python code binds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.parts import Source, everything_in

_BINDING = (facts.Statement, facts.Param, facts.Handler, facts.Pattern, facts.WithItem, facts.Generator, facts.Assigned)


def bound_by(part: facts.Base) -> Sequence[str]:
    """The names that a part binds, in whichever scope."""
    if not isinstance(part, _BINDING):  # most parts, which the kinds below need not be tried on
        return []
    match part:
        case facts.Function(name=name) | facts.Class(name=name) | facts.Param(name=name):
            return [name]
        case facts.Handler(name=str(name)) | facts.Pattern(name=str(name)):
            return [name]
        case facts.Import(module=module, alias=alias):
            return [alias or module.partition(".")[0]]
        case facts.ImportFrom(names=names):
            return [bound for _, bound in names]
        case facts.Global(names=names):
            return names
        case facts.Assign(targets=targets):
            return [name.id for name in everything_in(targets, facts.Name)]
        case (
            facts.Annotated()
            | facts.Augmented()
            | facts.For()
            | facts.WithItem()
            | facts.Generator()
            | facts.Assigned()
        ):
            return [name.id for name in everything_in(part.target, facts.Name)]
    return []


def given_by(part: facts.Base) -> Sequence[str]:
    """The names that a part gives a value, and not those of which it sets an item or an attribute."""
    match part:
        case facts.Assign(targets=targets):
            return [name for target in targets for name in _given_in(target)]
        case facts.Annotated() | facts.Augmented() | facts.For() | facts.WithItem() | facts.Generator():
            return [] if part.target is None else list(_given_in(part.target))
    return bound_by(part)


def _given_in(target: facts.Expr) -> Iterator[str]:
    match target:
        case facts.Name(id=name):
            yield name
        case facts.Sequence(elements=elements):
            for element in elements:
                yield from _given_in(element)
        case facts.Starred(value=value):
            yield from _given_in(value)


def names_bound(code: Source) -> Iterator[str]:
    """The names that some code binds, in whichever scope inside it; each as often as it is bound."""
    return (name for part in everything_in(code) for name in bound_by(part))


__all__ = ["bound_by", "given_by", "names_bound"]
