"""Results of the workspace's own functions that are None where an ``except`` of the function has caught something, and
that code uses as if that never happened: ``x, y = self.position()``, where a look-up of a transform may fail.

A function that catches the failure says itself that it may come.  Failures that only wrong code or a wrong argument
brings are no such thing, nor are those that the code around the use expects.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.own_calls import FunctionInFile, function_meant, method_meant, own_calls_of
from archlint.python_code.used_nothing import Use, uses_of_results
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.flow_facts import holds
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_EXPECTING = frozenset({"AttributeError", "BaseException", "Exception", "TypeError"})
_FROM_OUTSIDE = frozenset(
    {"ConnectivityException", "ExtrapolationException", "LookupException", "TransformException", "TransformError"}
    | {"ConnectionError", "CvBridgeError", "RequestException", "SerialException"}
    | {"UnicodeDecodeError"}
)
"""What comes in good code, too, whatever the arguments are: for a transform that is not there yet, a broken line."""
_OF_CODE = frozenset({"AttributeError", "IndexError", "KeyError", "NameError", "TypeError"})
"""What is not caught for the sake of calls that fail in good code."""
_FAIL = frozenset(
    {"compressed_imgmsg_to_cv2", "imgmsg_to_cv2", "lookup_transform", "readline", "recv", "transform", "urlopen"}
)
"""Calls that fail in good code, too: for what is not there yet, and for what comes from outside."""
_MAKES_SURE = frozenset({"can_transform", "wait_for_transform", "wait_for_transform_async"})


@dataclass(frozen=True)
class FailedResult:
    """A line that uses what ``name`` returns; ``returned`` is where that is None, behind an except of ``caught``."""

    place: Place
    name: str
    use: Use
    returned: Place
    caught: str


def failed_results(workspace: WorkspaceIndex) -> Iterator[FailedResult]:
    """The first such use of each call in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        rows = [*_in_file(workspace, path)]
        expecting = (_expecting(workspace, path) or ()) if rows else ()
        yield from (row for row in rows if not any(holds(span, row.place.span) for span in expecting))


def _in_file(workspace: WorkspaceIndex, path: str) -> Iterator[FailedResult]:
    rows = uses_of_results(workspace, path) or ()
    uses = {call: use for call, use in rows if use[0] in (Use.FAILS, Use.LOOKS_INTO)}
    for call in (own_calls_of(workspace, path) or ()) if uses else ():
        if call.span in uses:
            yield from _row(path, call.name, function_meant(workspace, path, call), uses[call.span])
    for called in (calls_of_objects(workspace, path) or ()) if uses else ():
        cls = class_of_object(workspace, path, called) if called.call in uses else None
        if cls is not None:
            yield from _row(path, called.written, method_meant(workspace, cls, called.name), uses[called.call])


def _row(path: str, name: str, meant: FunctionInFile | None, use: tuple[Use, facts.Span]) -> Iterator[FailedResult]:
    failure = None if meant is None else _failure_of(meant.code)
    if meant is not None and failure is not None:
        yield FailedResult(Place(path, *use[1]), name, use[0], Place(meant.file, *failure[1]), failure[0])


@once_for
def _failure_of(code: facts.Function) -> tuple[str, facts.Span] | None:
    """What an except of a function catches that then returns None, and where; None where that never happens, or where
    nothing else is returned."""
    if code.is_async or code.is_generator or code.name == "__init__":
        return None
    returns = [each for each in parts_of(code.body, facts.Return) if each.value is not None and not is_none(each.value)]
    for attempt in parts_of(code.body, facts.Try) if returns else ():
        for handler in attempt.handlers:
            end = _end_of(handler, attempt, code)
            if end is not None and _is_likely(handler, attempt):
                return _caught(handler), end
    return None


def _end_of(handler: facts.Handler, attempt: facts.Try, code: facts.Function) -> facts.Span | None:
    """Where a handler makes its function return None: by its last line, or as the end of the function follows."""
    last = handler.body[-1] if handler.body else None
    if isinstance(last, facts.Return):
        return last.span if last.value is None or is_none(last.value) else None
    tried = (attempt.orelse or attempt.body)[-1:]
    is_last = code.body[-1] is attempt and not attempt.final
    gives = bool(tried) and isinstance(tried[0], facts.Return) and tried[0].value is not None
    if is_last and gives and all(map(_only_tells, handler.body)):
        return handler.span
    return None


def _only_tells(statement: facts.Stmt) -> bool:
    """Whether a statement is a line of a log, or ``pass``."""
    match statement:
        case facts.Jump(kind="pass"):
            return True
        case facts.Expression(value=facts.Call(func=func)):
            return func.last_name in {"debug", "error", "fatal", "info", "print", "warn", "warning"}
    return False


def _caught(handler: facts.Handler) -> str:
    """What a handler catches, without the modules in front: ``LookupException`` of ``tf2_ros.LookupException``."""
    types = handler.type.elements if isinstance(handler.type, facts.Sequence) else [handler.type]
    return " or ".join(each.last_name for each in types if each is not None and each.last_name) or "anything"


def _is_likely(handler: facts.Handler, attempt: facts.Try) -> bool:
    """Whether what is tried can be expected to fail, by what fails or by the name of what is caught."""
    if handler.caught & _OF_CODE:
        return False
    fails = any(call.func.last_name in _FAIL for call in everything_in(attempt.body, facts.Call))
    return fails or not handler.caught.isdisjoint(_FROM_OUTSIDE)


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _expecting(code: facts.Facts) -> list[facts.Span]:
    """What is tried for any failure, and the functions that are called there or make sure that nothing fails."""
    attempts = [each for each in everything_in(code.body, facts.Try) if any(map(_expects, each.handlers))]
    tried = [part for attempt in attempts for part in attempt.body if not isinstance(part, facts.Global)]
    called = {call.func.last_name for call in everything_in(tried, facts.Call)}
    functions = everything_in(code.body, facts.Function)
    return [*(part.span for part in tried), *(each.span for each in functions if each.name in called or _is_sure(each))]


def _expects(handler: facts.Handler) -> bool:
    return handler.type is None or not handler.caught.isdisjoint(_EXPECTING)


def _is_sure(function: facts.Function) -> bool:
    return any(call.func.last_name in _MAKES_SURE for call in everything_in(function.body, facts.Call))


__all__ = ["FailedResult", "failed_results"]
