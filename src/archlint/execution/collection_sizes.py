"""How many items a loop goes over, where the file itself fills the collection and nothing else does."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

_SAME_SIZE = frozenset({"enumerate", "iter", "list", "reversed", "set", "sorted", "tuple"})
"""Functions that give as many items as they are given."""
_VIEWS = frozenset({"copy", "items", "keys", "values"})
_GROW = frozenset({"add", "append", "appendleft", "extend", "insert", "setdefault", "update"})
_LOOKS = _SAME_SIZE | {"any", "all", "isinstance", "len", "max", "min", "print", "str", "sum", "zip", "map", "filter"}
"""Functions that put nothing into what they are given."""


def most_items(iterable: facts.Expr, file: facts.Facts) -> int | None:
    """The most items that an expression in a file may have; None where that is not known.

    A display has as many as are written.  A variable or an attribute (of whatever object: its name counts) has as many
    as the largest display that the file gives it, and one more for each constant key that is set.
    """
    match iterable:
        case facts.Sequence() | facts.Mapping():
            return _displayed(iterable)
        case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=inner), *_]) if name in _SAME_SIZE:
            return most_items(inner, file)
        case facts.Call(func=facts.Attribute(value=inner, attr=name), args=[]) if name in _VIEWS:
            return most_items(inner, file)
        case facts.Name(id=name):
            return None if _is_parameter(name, file) else _Uses(name).most(file.body)
        case facts.Attribute(attr=name):
            return _Uses(name).most(file.body)
    return None


def _displayed(value: facts.Expr) -> int | None:
    match value:
        case facts.Sequence(elements=elements):
            return None if any(isinstance(element, facts.Starred) for element in elements) else len(elements)
        case facts.Mapping(keys=keys):
            return None if None in keys else len(keys)
    return None


def _is_parameter(name: str, file: facts.Facts) -> bool:
    return any(param.name == name for param in everything_in(file.body, facts.Param))


class _Uses:
    """What code does with a variable or an attribute of some name."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.sizes: list[int] = []
        self.keys: set[facts.Constant] = set()

    def most(self, code: Sequence[facts.Stmt]) -> int | None:
        if not all(self._is_plain(part) for part in everything_in(code)) or not self.sizes:
            return None
        return max(self.sizes) + len(self.keys)

    def _is(self, expression: facts.Base) -> bool:
        return self.name in (expression.variable, expression.attribute)

    def _is_plain(self, part: facts.Base) -> bool:
        """Whether a part of the code leaves it as large as it is known to be; notes how large that is."""
        match part:
            case facts.Assign(targets=targets, value=value):
                return not self._is(value) and all(self._takes(target, value) for target in targets)
            case facts.Annotated(target=target, value=value):
                return value is None or self._takes(target, value)
            case facts.Augmented(target=target) | facts.For(target=target) | facts.Generator(target=target):
                return not self._binds(target)
            case facts.Assigned(target=target):
                return not self._binds(target)
            case facts.WithItem(target=target):
                return target is None or not self._binds(target)
            case facts.Return(value=value):
                return value is None or not self._is(value)
            case facts.Call(func=facts.Attribute(value=inner, attr=method)) if self._is(inner):
                return method not in _GROW
            case facts.Call(args=args):
                return called_name(part) in _LOOKS or not any(self._is(argument.value) for argument in args)
        return True

    def _binds(self, target: facts.Expr) -> bool:
        return any(self._is(part) for part in target.unpacked) or self._is_item(target)

    def _is_item(self, target: facts.Expr) -> bool:
        return isinstance(target, facts.Subscript) and self._is(target.value)

    def _takes(self, target: facts.Expr, value: facts.Expr) -> bool:
        if self._is(target):
            size = _displayed(value)
            self.sizes += [] if size is None else [size]
            return size is not None
        match target:
            case facts.Subscript(value=inner, index=facts.Literal(value=key)) if self._is(inner):
                self.keys.add(key)
                return True
        return not self._binds(target)


__all__ = ["most_items"]
