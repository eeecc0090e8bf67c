"""Which functions can matter: those that create something, wait, spin, or hand over a callback."""

from __future__ import annotations

from functools import lru_cache

import msgspec

from archlint.facts import model as facts
from archlint.program.api import rclpy_names, tables

_ROWS = [row for row in tables.ROWS if row.effect != "none" or (row.watched and row.kind != tables.OUTSIDE)]

WORDS = (
    frozenset(row.path.rpartition(".")[2] for row in _ROWS)
    | rclpy_names.NODE_METHODS
    | {"Node", "LifecycleNode", "sleep", "wait", "result", "call"}
) - {"__init__", "join", "get", "path", "set"}
"""Names of the API tables, as they stand in source."""

_IMPORTED = frozenset(
    row.path.rpartition(".")[2] for row in tables.ROWS if not row.path.split(".")[-2][:1].isupper()
) | {"Node", "LifecycleNode"}
"""Those that a file may import and use as they are.  The rest are methods, which follow a dot: a variable that is
called ``result`` is no answer to a call."""


class _Key:
    __slots__ = ("ir",)

    def __init__(self, ir: object) -> None:
        self.ir = ir

    def __hash__(self) -> int:
        return id(self.ir)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Key) and other.ir is self.ir


def names_in(ir: object) -> frozenset[str]:
    """All names and attributes that a piece of facts uses."""
    return _names_in(_Key(ir))


@lru_cache(maxsize=50_000)
def _names_in(key: _Key) -> frozenset[str]:
    names, attributes = _names_and_attributes(key.ir)
    return frozenset(names | attributes)


def _names_and_attributes(ir: object) -> tuple[set[str], set[str]]:
    names: set[str] = set()
    attributes: set[str] = set()
    stack: list[object] = [ir]
    while stack:
        item = stack.pop()
        if isinstance(item, facts.Name):
            names.add(item.id)
        elif isinstance(item, msgspec.Struct):
            if isinstance(item, facts.Attribute):
                attributes.add(item.attr)
            stack.extend(getattr(item, name) for name in item.__struct_fields__)
        elif isinstance(item, (list, tuple)):
            stack.extend(item)
    return names, attributes


def interesting(ir: object) -> bool:
    """Whether a function or class uses a name of the API tables."""
    return not names_in(ir).isdisjoint(WORDS)


def uses_api(ir: object) -> bool:
    """Whether a function does more than have a variable of such a name: a method's name follows a dot."""
    return interesting(ir) and _uses_api(_Key(ir))


@lru_cache(maxsize=50_000)
def _uses_api(key: _Key) -> bool:
    names, attributes = _names_and_attributes(key.ir)
    return not (attributes.isdisjoint(WORDS) and names.isdisjoint(WORDS & _IMPORTED))
