"""Results of the workspace's own functions that code takes apart into another number of variables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.own_calls import FunctionInFile, function_meant, method_meant, own_calls_of
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class WrongLength:
    """``x, y = self.pose()``, where ``pose()`` always returns three values."""

    place: Place
    name: str
    wanted: int
    given: int
    returned: Place


def wrong_lengths(workspace: WorkspaceIndex) -> Iterator[WrongLength]:
    """Every such line in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        wanted = dict(_taken_apart(workspace, path) or ())
        for call in (own_calls_of(workspace, path) or ()) if wanted else ():
            row = wanted.get(call.span)
            meant = None if row is None else function_meant(workspace, path, call)
            returned = None if meant is None else _returned(meant)
            if row is not None and returned is not None and returned[0] != row[0]:
                place = Place(path, *row[1])
                yield WrongLength(place, call.name, row[0], returned[0], returned[1])
        for called in (calls_of_objects(workspace, path) or ()) if wanted else ():
            row = wanted.get(called.call)
            cls = None if row is None else class_of_object(workspace, path, called)
            meant = None if cls is None else method_meant(workspace, cls, called.name)
            returned = None if meant is None else _returned(meant)
            if row is not None and returned is not None and returned[0] != row[0]:
                place = Place(path, *row[1])
                yield WrongLength(place, called.written, row[0], returned[0], returned[1])


@kept_for_each_file
def _taken_apart(code: facts.Facts) -> list[tuple[facts.Span, tuple[int, facts.Span]]]:
    """The calls whose results go to several variables at once: how many, and the line."""
    expecting = tried_for(code.body, {"ValueError"})
    rows: list[tuple[facts.Span, tuple[int, facts.Span]]] = []
    for statement in everything_in(code.body, facts.Assign):
        match statement:
            case facts.Assign(targets=[facts.Sequence(elements=elements)], value=facts.Call(span=span)):
                starred = any(isinstance(element, facts.Starred) for element in elements)
                if not starred and Itself[facts.Base](statement) not in expecting:
                    rows.append((span, (len(elements), statement.span)))
    return rows


def _returned(function: FunctionInFile) -> tuple[int, Place] | None:
    """How many values a function returns wherever it ends, and where it first does so."""
    code = function.code
    if (
        code.is_async
        or code.decorators
        or code.name == "__init__"
        or any(True for _ in parts_of(code.body, facts.Yield))
    ):
        return None
    lengths: list[int] = []
    first: Place | None = None
    for statement in parts_of(code.body, facts.Return):
        match statement.value:
            case facts.Sequence(kind="tuple", elements=elements) if not any(
                isinstance(element, facts.Starred) for element in elements
            ):
                lengths.append(len(elements))
                first = first or Place(function.file, *statement.span)
            case _:
                return None
    return (lengths[0], first) if first is not None and len(set(lengths)) == 1 else None


__all__ = ["WrongLength", "wrong_lengths"]
