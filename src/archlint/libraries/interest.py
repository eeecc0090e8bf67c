"""Which functions can matter: those that create something, wait, spin, or hand over a callback."""

from __future__ import annotations

from functools import lru_cache

import msgspec

from archlint.libraries import tables
from archlint.libraries.rclpy import names
from archlint.syntax import facts

_QUIET = frozenset(
    {"result", "done", "get", "path", "join", "partial", "function", "sleep", "wait", "input", "setup", "Parameter"}
)

WORDS = (
    frozenset(
        row.path.rpartition(".")[2]
        for row in tables.ROWS
        if row.effect != "none" or (row.watched and row.kind != tables.OUTSIDE)
    )
    | names.NODE_METHODS
    | {"Node", "LifecycleNode", "sleep", "wait", "result", "call"}
) - {"__init__", "join", "get", "path", "set"}
"""Names of the API tables, as they stand in source."""


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
    found: set[str] = set()
    stack: list[object] = [key.ir]
    while stack:
        item = stack.pop()
        if isinstance(item, facts.Name):
            found.add(item.id)
        elif isinstance(item, msgspec.Struct):
            if isinstance(item, facts.Attribute):
                found.add(item.attr)
            stack.extend(getattr(item, name) for name in item.__struct_fields__)
        elif isinstance(item, (list, tuple)):
            stack.extend(item)
    return frozenset(found)


def interesting(ir: object) -> bool:
    """Whether a function or class uses a name of the API tables."""
    return not names_in(ir).isdisjoint(WORDS)
