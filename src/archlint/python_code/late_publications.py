"""Messages that a program publishes once rclpy is shut down, so that they are never sent: the last command to stop.

Source: ``rclpy.init()`` installs a handler that shuts down every context at SIGINT and SIGTERM, before the spin of the
main thread ends with KeyboardInterrupt.  ``Publisher.publish()`` raises RCLError then: "publisher's context is
invalid".  Tried with rclpy of jazzy and kilted: always behind ``rclpy.spin()`` and the ``spin()`` of an executor, and
at times behind ``spin_once()``, which is left out here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.endless_constructors import comes_back, endless_classes
from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.own_calls import method_meant
from archlint.python_code.second_shutdowns import (
    INTERRUPT,
    OF_SIGNALS,
    asks_whether_it_runs,
    leaves,
    targets_of_threads,
)
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MAKE_PUBLISHERS = frozenset({"create_lifecycle_publisher", "create_publisher"})
_SHUT_DOWN = frozenset({"rclpy.shutdown", "rclpy.try_shutdown"})


@dataclass(frozen=True)
class LatePublication:
    """A call behind the end of rclpy that publishes, itself or by a ``method`` that does at ``publishes``."""

    place: Place
    after_interrupt: bool
    """Whether Ctrl-C ends rclpy, and not a line of the program."""
    method: str = ""
    publishes: Place | None = None


@dataclass(frozen=True)
class _Call:
    span: facts.Span
    after_interrupt: bool
    publishes: bool
    """Whether it is ``publish()`` itself."""


def late_publications(workspace: WorkspaceIndex) -> Iterator[LatePublication]:
    """The first such call behind each end of rclpy in the files that were asked for, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        rows: dict[Place, LatePublication] = {}
        for calls in _behind_ends(workspace, path) or ():
            late = (_late(workspace, path, call) for call in calls)
            first = next((row for row in late if row is not None), None)
            if first is not None:
                rows.setdefault(first.place, first)
        yield from rows.values()


def _late(workspace: WorkspaceIndex, path: str, call: _Call) -> LatePublication | None:
    if call.publishes:
        return LatePublication(Place(path, *call.span), call.after_interrupt)
    called = next((each for each in calls_of_objects(workspace, path) or () if each.call == call.span), None)
    cls = None if called is None else class_of_object(workspace, path, called)
    meant = None if cls is None or called is None else method_meant(workspace, cls, called.name)
    code = None if meant is None else workspace.facts_at(meant.file)
    if code is None or meant is None or called is None:
        return None
    published = next(_published(meant.code.body, _publishers(code)), None)
    if published is None:
        return None
    return LatePublication(Place(path, *call.span), call.after_interrupt, called.name, Place(meant.file, *published))


def _published(block: Sequence[facts.Stmt], publishers: Set[str]) -> Iterator[facts.Span]:
    """The publications that a block always comes to."""
    for statement in block:
        if statement.blocks and not isinstance(statement, (facts.With, facts.For)):
            if any(leaves(inner) for body in statement.blocks for inner in statements_of(body)):
                return
            continue
        if isinstance(statement, facts.With):
            yield from _published(statement.body, publishers)
            continue
        yield from (call.span for call in calls_in(statement) if _is_publication(call, publishers))
        if leaves(statement):
            return


def _is_publication(call: facts.Call, publishers: Set[str]) -> bool:
    match call:
        case facts.Call(func=facts.Attribute(value=owner, attr="publish"), args=[facts.Argument(star="")]):
            return owner.last_name in publishers
    return False


def _publishers(code: facts.Facts) -> frozenset[str]:
    """What a file calls publishers that it creates: variables and attributes, whichever object has these."""
    creations = [
        statement
        for statement in everything_in(code.body, facts.Assign)
        if isinstance(statement.value, facts.Call) and statement.value.func.attribute in _MAKE_PUBLISHERS
    ]
    return frozenset(target.last_name for statement in creations for target in statement.targets if target.last_name)


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _behind_ends(code: facts.Facts) -> list[list[_Call]]:
    """The calls that a program comes to behind each end of rclpy, in order, unless they ask whether it runs."""
    if not OF_SIGNALS.isdisjoint(code.names):
        return []
    publishers, threads = _publishers(code), targets_of_threads(code)
    blocks = [code.body, *(f.body for f in everything_in(code.body, facts.Function) if f.name not in threads)]
    endless = endless_classes(code)
    return [[*calls] for block in blocks for calls in _ends_in(block, publishers, endless)]


def _ends_in(block: Sequence[facts.Stmt], publishers: Set[str], endless: Set[str]) -> Iterator[Iterator[_Call]]:
    """The calls behind each end of rclpy in a block, but for one that Ctrl-C in an ``endless`` constructor skips."""
    for at, statement in enumerate(block):
        if isinstance(statement, (facts.Function, facts.Class)):
            continue
        match statement:
            case facts.Try() if _spins(statement.body) and comes_back([*block[:at], *statement.body], endless):
                yield _after(_behind(statement, block[at + 1 :]), publishers, after_interrupt=True)
            case facts.Expression(value=facts.Call(func=function)) if function.dotted in _SHUT_DOWN:
                yield _after(block[at + 1 :], publishers, after_interrupt=False)
        for inner in statement.blocks:
            yield from _ends_in(inner, publishers, endless)


def _behind(attempt: facts.Try, after: Sequence[facts.Stmt]) -> list[facts.Stmt]:
    """What a program comes to when Ctrl-C ends the spin in a ``try``."""
    catching = [handler for handler in attempt.handlers if handler.type is None or handler.caught & INTERRUPT][:1]
    inside = [statement for handler in catching for statement in handler.body]
    goes_on = bool(catching) and not any(leaves(statement) for statement in statements_of(inside))
    return [*inside, *attempt.final, *(after if goes_on else ())]


def _after(block: Sequence[facts.Stmt], publishers: Set[str], *, after_interrupt: bool) -> Iterator[_Call]:
    for statement in block:
        if statement.blocks:
            if isinstance(statement, facts.Try) and any(map(_starts_again, statements_of(statement.body))):
                return
            continue  # it may ask whether rclpy runs, or go on after an error
        if asks_whether_it_runs(statement) or _starts_again(statement):
            return
        for call in calls_in(statement):
            yield _Call(call.span, after_interrupt, _is_publication(call, publishers))
        if leaves(statement):
            return


def _starts_again(statement: facts.Stmt) -> bool:
    return any(call.func.last_name == "init" for call in calls_in(statement))


def _spins(body: Sequence[facts.Stmt]) -> bool:
    """Whether a block spins until the end, in the lines of the block alone."""
    calls = (call for statement in body if not statement.blocks for call in calls_in(statement))
    return any(call.func.attribute == "spin" for call in calls)


__all__ = ["LatePublication", "late_publications"]
