"""Objects of the workspace in a ``with`` that gives its variable None, since their ``__enter__()`` returns nothing.

Source: Python's reference, "The with statement": the target gets the return value of ``__enter__()``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, class_named, methods_of
from archlint.python_code.tried_code import tried_for
from archlint.python_code.used_nothing import returns_nothing, tests_in
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_ENTER = "__enter__"
_SPINS = frozenset({"rclpy.spin", "rclpy.spin_once", "rclpy.spin_until_future_complete"})
"""What looks into its first argument, a node.  Source: ``Executor.add_node`` sets ``node.executor``."""


@dataclass(frozen=True)
class EnteredNothing:
    """``with Robot() as robot:``, and the line that needs ``robot``; ``defined`` is the method that returns nothing."""

    place: Place
    variable: str
    cls: str
    used: Place
    defined: Place


def entered_nothing(workspace: WorkspaceIndex) -> Iterator[EnteredNothing]:
    """Every such statement in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for called, variable, span, used in _entered(workspace, path) or ():
            cls = class_named(workspace, path, called)
            if isinstance(cls, ClassInFile) and (enter := _enter_of(workspace, cls)) is not None:
                place, at = Place(path, *span), Place(path, *used)
                yield EnteredNothing(place, variable, cls.code.name, at, enter)


def _enter_of(workspace: WorkspaceIndex, cls: ClassInFile) -> Place | None:
    """The ``__enter__()`` of a class, if it returns nothing and stands in the class itself."""
    own = [method for method in methods_of(cls.code) if method.name == _ENTER]
    if len(own) != 1 or not returns_nothing(own[0]) or not chain_of(workspace, cls).complete:
        return None
    return Place(cls.file, *own[0].name_span)


_Row = tuple[str, str, facts.Span, facts.Span]
"""What is called, the variable, where that stands, and where it is used."""


@kept_for_each_file
def _entered(code: facts.Facts) -> list[_Row]:
    statements = [*everything_in(code.body, facts.With)]
    expecting = tried_for(code.body, {"AttributeError", "TypeError", "Exception", ""}) if statements else set()
    rows: list[_Row] = []
    for statement in statements:
        for item in statement.items if not statement.is_async else ():
            match item:
                case facts.WithItem(facts.Call(func=called), facts.Name(id=name, span=span)):
                    used = _use_in(statement, name, expecting)
                    rows += [] if used is None else [(called.dotted, name, span, used)]
    return rows


def _use_in(statement: facts.With, name: str, expecting: set[Itself[facts.Base]]) -> facts.Span | None:
    """The first line that fails if a variable is None; None where the block gives it another value, or asks for it."""
    parts = [*everything_in(statement.body)]
    asks = any(each.id == name for part in parts for each in everything_in(tests_in(part), facts.Name))
    if asks or any(name in bound_by(part) for part in parts):
        return None
    for part in parts:
        match part:
            case facts.Attribute(value=facts.Name(id=looked_into), span=span) if looked_into == name:
                return span if Itself[facts.Base](part) not in expecting else None
            case facts.Call(func=called, args=[facts.Argument(value=facts.Name(id=given)), *_], span=span):
                if given == name and called.dotted in _SPINS:
                    return span if Itself[facts.Base](part) not in expecting else None
    return None


__all__ = ["EnteredNothing", "entered_nothing"]
