"""Collections that a file fills as it makes them, and takes nothing out of again: a loop over one goes round."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

_AS_MANY = frozenset({"enumerate", "iter", "list", "reversed", "set", "sorted", "tuple"})
"""Functions that give items where they are given some."""
_VIEWS = frozenset({"copy", "items", "keys", "values"})
_SHRINK = frozenset({"clear", "discard", "pop", "popitem", "popleft", "remove"})


def is_never_empty(iterable: facts.Expr, file: facts.Facts) -> bool:
    """Whether an expression in a file has an item for certain: a variable or an attribute (of whatever object: its name
    counts) has one if the file gives it displays alone, none of them empty, and never takes an item out."""
    match iterable:
        case facts.Sequence(elements=elements):
            return any(not isinstance(element, facts.Starred) for element in elements)
        case facts.Mapping(keys=keys):
            return any(key is not None for key in keys)
        case facts.Call(func=facts.Name(id="range"), args=[*_, facts.Argument(value=facts.Literal(value=int(number)))]):
            return number > 0 and len(iterable.args) == 1
        case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=inner), *_]) if name in _AS_MANY:
            return is_never_empty(inner, file)
        case facts.Call(func=facts.Attribute(value=inner, attr=name), args=[]) if name in _VIEWS:
            return is_never_empty(inner, file)
        case facts.Name(id=name):
            return not _is_parameter(name, file) and _is_kept_full(file, lambda part: part.variable == name)
        case facts.Attribute(attr=name):
            return _is_kept_full(file, lambda part: part.attribute == name)
    return False


def _is_parameter(name: str, file: facts.Facts) -> bool:
    return any(param.name == name for param in everything_in(file.body, facts.Param))


def _is_kept_full(file: facts.Facts, is_it: Callable[[facts.Base], bool]) -> bool:
    if any(_takes_out(part, is_it) for part in everything_in(file.body)):
        return False
    values = [*_given(file, is_it)]
    displays = (facts.Sequence, facts.Mapping)
    return bool(values) and all(isinstance(value, displays) and is_never_empty(value, file) for value in values)


def _given(file: facts.Facts, is_it: Callable[[facts.Base], bool]) -> Iterator[facts.Expr | None]:
    """All that a file gives it; None for what is no plain value."""
    for part in everything_in(file.body):
        match part:
            case facts.Assign(targets=targets, value=value):
                yield from (value if is_it(target) else None for target in targets if _binds(target, is_it))
            case facts.Annotated(target=target, value=value) if value is not None and _binds(target, is_it):
                yield value
            case facts.For(target=target) | facts.Generator(target=target) | facts.Assigned(target=target) if _binds(
                target, is_it
            ):
                yield None
            case facts.WithItem(target=target) if target is not None and _binds(target, is_it):
                yield None


def _binds(target: facts.Expr, is_it: Callable[[facts.Base], bool]) -> bool:
    return any(is_it(part) for part in target.unpacked)


def _takes_out(part: facts.Base, is_it: Callable[[facts.Base], bool]) -> bool:
    match part:
        case facts.Call(func=facts.Attribute(value=inner)):
            return is_it(inner) and called_name(part) in _SHRINK
        case facts.Delete():
            return any(is_it(inner) for inner in everything_in(part))
        case facts.Assign(targets=targets):
            slices = (target for target in targets if isinstance(target, facts.Subscript))
            return any(is_it(target.value) and isinstance(target.index, facts.Slice) for target in slices)
    return False


__all__ = ["is_never_empty"]
