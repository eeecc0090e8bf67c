"""Publishers and clients whose variable gets another one before anything has used them: nothing can send with them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MAKE = {"create_publisher": "publisher", "create_client": "client", "ActionClient": "action client"}
_TOPICS = {"create_publisher": 1, "create_client": 1, "ActionClient": 2}
"""Where the name stands among the arguments."""


@dataclass(frozen=True)
class OverwrittenEnd:
    """``self.pub = self.create_publisher(…)``, of some ``name`` as it is written, and the line that takes its place."""

    place: Place
    target: str
    kind: str
    name: str
    again: Place


def overwritten_ends(workspace: WorkspaceIndex) -> Iterator[OverwrittenEnd]:
    """Every such line in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for first, second, target, kind, name in _overwritten(workspace, path) or ():
            yield OverwrittenEnd(Place(path, *first), target, kind, name, Place(path, *second))


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _overwritten(code: facts.Facts) -> list[tuple[facts.Span, facts.Span, str, str, str]]:
    rows = [row for function in everything_in(code.body, facts.Function) for row in _in_body(function.body)]
    read = _read_in(code) if rows else frozenset()
    return [row for row in rows if row[2] in read]  # what nothing sends with is a sketch


def _read_in(code: facts.Facts) -> frozenset[str]:
    """The variables and attributes that a file reads, as they are written."""
    parts = [*everything_in(code.body)]
    written = {Itself(target) for part in parts for target in part.assigned}
    return frozenset(part.dotted for part in parts if part.dotted and Itself(part) not in written)


def _in_body(body: Sequence[facts.Stmt]) -> Iterator[tuple[facts.Span, facts.Span, str, str, str]]:
    """The same of the lines of a function that stand one below the other, with nothing to decide between them."""
    unused: dict[str, tuple[facts.Span, str, str]] = {}
    for statement in body:
        end = _made(statement)
        if end is None:
            used = {part.dotted for part in everything_in([statement]) if part.dotted}
            if _runs_own_code(statement) or statement.blocks:
                unused.clear()
            unused = {target: row for target, row in unused.items() if target not in used}
            continue
        target, function, name, span = end
        before = unused.get(target)
        if before is not None and before[1] == function and name and before[2] and before[2] != name:
            yield before[0], span, target, _MAKE[function], before[2]
        unused[target] = (span, function, name)


def _made(statement: facts.Stmt) -> tuple[str, str, str, facts.Span] | None:
    """What an assignment makes: its target, the function, the name that is given as a text, and where."""
    match statement:
        case facts.Assign(targets=[target], value=facts.Call(func=func, args=args), span=span) if target.dotted:
            at = _TOPICS.get(func.last_name)
            if at is None or len(args) <= at or any(argument.star for argument in args):
                return None
            plain = args[at].keyword is None
            return target.dotted, func.last_name, (args[at].value.text or "") if plain else "", span
    return None


def _runs_own_code(statement: facts.Stmt) -> bool:
    """Whether a line calls a function that may use what the object or the function has by then."""
    calls = everything_in([statement], facts.Call)
    return any(not call.func.last_name.startswith(("create_", "declare_", "get_")) for call in calls)


__all__ = ["OverwrittenEnd", "overwritten_ends"]
