"""What a piece of facts holds: every fact inside it, and the names that it uses."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any, TypeVar, overload

from archlint.syntax import facts

Kind = TypeVar("Kind", bound=facts.Base)


class Itself:
    """A fact as a key: equal to itself alone, for comparing by content would cost a walk."""

    __slots__ = ("fact",)

    def __init__(self, fact: Any) -> None:
        self.fact = fact

    def __hash__(self) -> int:
        return id(self.fact)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Itself) and other.fact is self.fact


@overload
def everything_in(fact: object) -> Iterator[facts.Base]: ...


@overload
def everything_in(fact: object, kind: type[Kind]) -> Iterator[Kind]: ...


def everything_in(fact: object, kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every fact (of a kind) inside another, those of the functions inside it too, in the order of the source."""
    stack: list[object] = [fact]
    while stack:
        item = stack.pop()
        if isinstance(item, (list, tuple)):
            stack.extend(reversed(item))
        elif isinstance(item, facts.Base):
            if isinstance(item, kind):
                yield item
            stack.extend(getattr(item, name) for name in reversed(item.__struct_fields__))


def names_in(ir: object) -> frozenset[str]:
    """All names and attributes that a piece of facts uses."""
    return _names_in(Itself(ir))


@lru_cache(maxsize=50_000)
def _names_in(key: Itself) -> frozenset[str]:
    found: set[str] = set()
    for item in everything_in(key.fact):
        if isinstance(item, facts.Name):
            found.add(item.id)
        elif isinstance(item, facts.Attribute):
            found.add(item.attr)
    return frozenset(found)


__all__ = ["Itself", "everything_in", "names_in"]
