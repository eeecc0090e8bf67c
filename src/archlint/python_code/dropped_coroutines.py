"""Calls of the workspace's own ``async`` functions whose coroutine nobody gets: none of what they do is done.

rclpy awaits a callback that is such a function itself, and none that a lambda calls: ``await_or_execute()`` of
rclpy/executors.py asks what it is given whether it is one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.own_calls import function_meant, method_meant, own_calls_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of

if TYPE_CHECKING:
    from archlint.python_code.own_calls import FunctionInFile
    from archlint.systems.model import WorkspaceIndex

_TAKE_CALLBACKS = frozenset({"add_done_callback", "create_service", "create_subscription", "create_timer"})


@dataclass(frozen=True)
class DroppedCoroutine:
    """Such a call, as it is written, and where the function is defined."""

    place: Place
    name: str
    defined: Place
    in_lambda: bool
    """Whether a lambda makes it that is a callback."""
    may_await: bool
    """Whether it stands in an ``async`` function."""


def dropped_coroutines(workspace: WorkspaceIndex) -> Iterator[DroppedCoroutine]:
    """Every such call in the files that use rclpy, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        dropped = {span: (in_lambda, may_await) for span, in_lambda, may_await in _dropped(workspace, path) or ()}
        for span, name, meant in _meant(workspace, path) if dropped else ():
            row = dropped.get(span)
            if row is not None and meant.code.is_async and not meant.code.is_generator:
                defined = Place(meant.file, *meant.code.name_span)
                yield DroppedCoroutine(Place(path, *span), name, defined, *row)


def _meant(workspace: WorkspaceIndex, path: str) -> Iterator[tuple[facts.Span, str, FunctionInFile]]:
    """The calls of a file of which it is known what they run."""
    for call in own_calls_of(workspace, path) or ():
        meant = function_meant(workspace, path, call)
        if meant is not None:
            yield call.span, call.name, meant
    for called in calls_of_objects(workspace, path) or ():
        cls = class_of_object(workspace, path, called)
        meant = None if cls is None else method_meant(workspace, cls, called.name)
        if meant is not None:
            yield called.call, called.written, meant


@kept_for_each_file
def _dropped(code: facts.Facts) -> list[tuple[facts.Span, bool, bool]]:
    """The calls that are a line of their own, and those that are all of a lambda which is given as a callback."""
    awaiting = [function for function in everything_in(code.body, facts.Function) if function.is_async]
    may_await = {line.span for function in awaiting for line in parts_of(function.body, facts.Expression)}
    rows = []
    for line in everything_in(code.body, facts.Expression):
        match line.value:
            case facts.Call(span=span):
                rows.append((span, False, line.span in may_await))
    for call in everything_in(code.body, facts.Call):
        for argument in call.args if call.func.attribute in _TAKE_CALLBACKS else ():
            match argument.value:
                case facts.Lambda(body=facts.Call(span=span)):
                    rows.append((span, True, False))
    return rows


__all__ = ["DroppedCoroutine", "dropped_coroutines"]
