"""What of one side is what of the other."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import field
from typing import Generic, TypeVar

from archlint.comparing.graphs import End, EndKind, Node
from archlint.records import dataclass

_Item = TypeVar("_Item")
_Key = Callable[[_Item], Hashable | None]


@dataclass
class Pairs(Generic[_Item]):
    """The items of both sides: those that are the same, and those that only one has."""

    both: list[tuple[_Item, _Item]] = field(default_factory=list)
    removed: list[_Item] = field(default_factory=list)
    added: list[_Item] = field(default_factory=list)


def paired(
    before: Sequence[_Item], after: Sequence[_Item], same: Sequence[_Key[_Item]], only: Sequence[_Key[_Item]] = ()
) -> Pairs[_Item]:
    """Pair by one key after another; items with the key None wait for the next one.

    A key of ``same`` counts where each side has as many items with it, one of ``only`` where each side has one.
    """
    pairs = Pairs[_Item]([], list(before), list(after))
    for key in same:
        _pair(pairs, key)
    for key in only:
        _pair(pairs, key, most=1)
    return pairs


def _pair(pairs: Pairs[_Item], key: _Key[_Item], most: int | None = None) -> None:
    old, new = _by_key(pairs.removed, key), _by_key(pairs.added, key)
    taken: set[int] = set()
    for value, items in old.items():
        others = new.get(value, [])
        if len(items) == len(others) and (most is None or len(items) <= most):
            pairs.both += zip(items, others, strict=True)
            taken.update(map(id, (*items, *others)))
    pairs.removed = [item for item in pairs.removed if id(item) not in taken]
    pairs.added = [item for item in pairs.added if id(item) not in taken]


def _by_key(items: Sequence[_Item], key: _Key[_Item]) -> dict[Hashable, list[_Item]]:
    groups: dict[Hashable, list[_Item]] = {}
    for item in items:
        value = key(item)
        if value:
            groups.setdefault(value, []).append(item)
    return groups


def paired_nodes(before: Sequence[Node], after: Sequence[Node]) -> Pairs[Node]:
    """The nodes by their names; one that has another name is the same where class and file say so."""
    return paired(
        before,
        after,
        same=[
            lambda node: node.name and (node.name, node.package, node.class_name, node.executable),
            lambda node: node.name and (node.name, node.package),
            lambda node: node.name,
        ],
        only=[
            lambda node: node.class_name and (node.package, node.class_name, node.file, node.executable),
            lambda node: node.class_name and (node.package, node.class_name, node.file),
        ],
    )


def paired_ends(before: Node, after: Node) -> Pairs[tuple[EndKind, End]]:
    """The ends of a node: by their names, else by what is written, the parameter and the callback, where one of
    these is the same."""
    return paired(
        before.ends(),
        after.ends(),
        same=[
            lambda row: row[1].name and (row[0], row[1].name, row[1].type),
            lambda row: row[1].name and (row[0], row[1].name),
        ],
        only=[
            lambda row: row[1].written and row[1].type and (row[0], row[1].written, row[1].type),
            lambda row: row[1].parameter and row[1].type and (row[0], row[1].parameter, row[1].type),
            lambda row: row[1].callback and row[1].type and (row[0], row[1].callback, row[1].type),
            lambda row: None if row[1].is_known else (row[0], row[1].type),
        ],
    )
