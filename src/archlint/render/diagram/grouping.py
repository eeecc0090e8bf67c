"""The frames of a picture, around what nodes have in common."""

from __future__ import annotations

from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.render.diagram.model import Shape
from archlint.render.look import UNOWNED
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from archlint.render.diagram.model import Diagram, Key
    from archlint.render.view import GroupBy


def grouped(diagram: Diagram, by: GroupBy | None) -> Diagram:
    """The diagram with frames around what nodes have in common; without ``by``, namespaces where there are several,
    else packages.  An interface belongs to a group if all its nodes do.  What is no node has a group of its own."""
    nodes = {key: shape for key, shape in diagram.shapes.items() if key[0] == NODE}
    real = [shape for shape in nodes.values() if not shape.helper]
    criterion = by or ("namespace" if _several(real, "namespace") else "package")
    several = by is not None or _several(real, criterion)
    titles = {
        key: UNOWNED if shape.helper else shape.groups.get(criterion, "") if several else ""
        for key, shape in nodes.items()
    }
    around: dict[Key, set[str]] = {}
    for line in diagram.lines:
        for key, other in (line.ends, line.ends[::-1]):
            if key not in nodes and other in nodes:
                around.setdefault(key, set()).add(titles[other])
    for key in diagram.shapes:
        if key not in nodes:
            own = around.get(key, set())
            titles[key] = next(iter(own)) if len(own) == 1 else ""
    return replace(diagram, groups={key: title for key, title in titles.items() if title})


def _several(shapes: Iterable[Shape], by: GroupBy) -> bool:
    return len({shape.groups.get(by, "") for shape in shapes}) > 1


def titled(diagram: Diagram, patterns: Sequence[str]) -> frozenset[str]:
    """The titles of groups that have one of the patterns."""
    return titles_of({*diagram.groups.values()}, patterns)


def titles_of(titles: Iterable[str], patterns: Sequence[str]) -> frozenset[str]:
    """Those that have one of the patterns; what is in no group has no title."""
    return frozenset(title for title in titles if title and any(fnmatchcase(title, pattern) for pattern in patterns))


__all__ = ["grouped", "titled", "titles_of"]
