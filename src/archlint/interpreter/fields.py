"""The slots of an object that no name of the interpreted code reaches: what the run itself keeps there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Generic, TypeVar

from archlint.records import dataclass

T = TypeVar("T")


def _latest(left: Sequence[T]) -> T:
    return left[-1]


class Field(Generic[T]):
    """A slot of objects, and what it is where several branches have left something else there."""

    __slots__ = ("is_of_all", "join", "name")

    def __init__(self, name: str, join: Callable[[Sequence[T]], T] = _latest, *, is_of_all: bool = False) -> None:
        self.name = name
        self.join = join
        self.is_of_all = is_of_all
        """Whether modules add to it whatever module the object is of; who reads it asks for all of them."""

    def __repr__(self) -> str:
        return f"<{self.name}>"


@dataclass(frozen=True, repr=False)
class Fields(Generic[T]):
    """A field for each of some names: ``ARGUMENTS["rate"]``."""

    name: str
    join: Callable[[Sequence[T]], T] = _latest

    def __getitem__(self, name: str) -> Field[T]:
        return _Named(self, name)


class _Named(Field[T]):
    """One of several fields: equal to whatever its family has under the same name."""

    __slots__ = ("family", "key")

    def __init__(self, family: Fields[T], key: str) -> None:
        super().__init__(f"{family.name} {key}", family.join)
        self.family = family
        self.key = key

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Named) and self.family is other.family and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.name)


def key_in(family: Fields[T], slot: object) -> str | None:
    """The name under which a family has a slot; None for slots that are none of it."""
    return slot.key if isinstance(slot, _Named) and slot.family is family else None


__all__ = ["Field", "Fields", "key_in"]
