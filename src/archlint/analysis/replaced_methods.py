"""Methods that never run, since a later one of the same name in the same class takes their place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex


def is_replaced(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place is in a method that a later one of its class replaces."""
    replaced = None if workspace is None else _replaced(workspace, place.file)
    spans = replaced or ()
    return any(span[:2] <= (place.line, place.column) <= span[2:] for span in spans)


@kept_for_each_file
def _replaced(code: facts.Facts) -> list[facts.Span]:
    """Where those of a file stand.  A decorator may keep the method that it is given, ``@value.setter``, and so may
    what the body of the class does with its name."""
    rows: list[facts.Span] = []
    for cls in everything_in(code.body, facts.Class):
        named = {part.id for part in parts_of(cls.body, facts.Name)}
        last: dict[str, facts.Function] = {}
        for method in (item for item in cls.body if isinstance(item, facts.Function)):
            before = last.get(method.name)
            if before is not None and not (before.decorators or method.decorators or method.name in named):
                rows.append(before.span)
            last[method.name] = method
    return rows


__all__ = ["is_replaced"]
