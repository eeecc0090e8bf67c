"""TMO004: loops that only the appearance of a service or an action server ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.left_over import is_dead, is_never_made
from archlint.analysis.reach import calls_of, creations_of, endpoint_words, has_limit, node_name
from archlint.analysis.source_code import Loop, source_code
from archlint.analysis.stuck import clients_of_handlers
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.timeouts import READY, WAIT_FOR_SERVER, WAIT_FOR_SERVICE, way_to
from archlint.finding import Finding, Place, Related, Severity
from archlint.syntax import facts
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System

_ASKS = frozenset({"wait_for_service", "wait_for_server", "service_is_ready", "server_is_ready"})
"""Methods that tell whether a server is there."""

_PASTIMES = frozenset(
    {"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log", "print"}
    | {"sleep", "spin_once", "get_logger", "get_clock", "now", "sleep_for", "flush", "format", "join"}
    | {"str", "len", "range", "time", "monotonic"}
    | _ASKS
)
"""Calls of which none ends a loop; any other may raise, so a loop with one is not judged."""


@rule("TMO004", scope=Scope.CODE, in_use=True)
def endless_wait_loop(system: System, options: Options) -> Iterator[Finding]:
    """Loops that go round until a server appears, and that nothing else ends."""
    asked = clients_of_handlers(system, options.distros)
    code = source_code(system)
    loops: dict[Place, list[ApiCall]] = {}
    for program, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY)):
        if not (call.api in READY or has_limit(call, "timeout_sec")) or not _only_the_server_ends(code.loop(call)):
            continue
        if is_dead(system.workspace, program, call) or is_never_made(system.workspace, call):
            continue
        if any(Place.of(call.file, one.span) in program.refused for one in calls_in(code.loop(call))):
            continue  # an error ends the loop
        # A handler that asks the server afterwards is SRV003's: this is part of the same wait.
        if asked.isdisjoint((call.context.place, client.place) for client in creations_of(call.receiver)):
            loops.setdefault(call.loops[-1], []).append(call)
    yield from (_endless(system, loops[key]) for key in sorted(loops))


def _endless(system: System, calls: Sequence[ApiCall]) -> Finding:
    """A callback that loops holds up its node; a program that starts up has nothing else to do yet."""
    in_callback = [call for call in calls if runs_in_executor(call.context)]
    call = (in_callback or calls)[0]
    kind = "action" if call.api.startswith("rclpy.action.") else "service"
    missing = endpoint_words(call.creation, kind)
    ready = "server_is_ready" if kind == "action" else "service_is_ready"
    stands = "the callback does not return and blocks its thread" if in_callback else "the node does nothing else"
    found = finding(
        "TMO004",
        call.place,
        f"this loop ends only when {missing} becomes available: until then {stands}",
        help=f"check without waiting, and handle the case that it is missing: if not ….{ready}():"
        if in_callback
        else "end the loop when ROS shuts down: while rclpy.ok() and not …:",
        related=way_to(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, "" if call.creation is None else call.creation.name.text or "", "loop"),
    )
    return found if in_callback else replace(found, severity=Severity.INFO, group=(call.file, call.function))


@folds("TMO004")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """The finding for all such loops that a program comes to one after the other as it starts."""
    first, *others = findings
    loops, do = ("another loop", "does") if len(others) == 1 else (f"{len(others)} more loops", "do")
    return replace(
        first,
        message=f"{first.message}; {loops} in {first.group[1]}() {do} the same",
        related=(*first.related, *(Related(one.place, "another such loop is here") for one in others)),
    )


def _only_the_server_ends(loop: Loop | None) -> bool:
    if not isinstance(loop, facts.While):
        return False
    if _says(loop.test, there=False):
        return not _leaves(loop.body)
    if isinstance(loop.test, facts.Literal) and loop.test.value:
        return _leaves_when_there(loop.body) and not _leaves(loop.body, unless_there=True)
    return _asks_a_variable(loop) and not _leaves(loop.body, unless_there=True)


def _says(test: facts.Expr, there: bool) -> bool:
    """Whether a condition holds just as long as servers are there, or (``there`` false) are missing."""
    if isinstance(test, facts.Unary) and test.op == "not":
        return _says(test.operand, not there)
    if isinstance(test, facts.Boolean):
        return all(_says(value, there) for value in test.values)
    if isinstance(test, facts.Compare):
        [wanted, *more] = test.comparators
        same = isinstance(wanted, facts.Literal) and isinstance(wanted.value, bool) and not more
        if not same or test.ops[0] not in ("==", "is") or not isinstance(wanted, facts.Literal):
            return False
        return _says(test.left, there if wanted.value else not there)
    if isinstance(test, facts.Assigned):
        return _says(test.value, there)
    asks = isinstance(test, facts.Call) and isinstance(test.func, facts.Attribute) and test.func.attr in _ASKS
    return there and asks


def _asks_a_variable(loop: facts.While) -> bool:
    """``while not ready``, where nothing in the loop but an answer about a server sets ``ready``."""
    test = loop.test
    if not (isinstance(test, facts.Unary) and test.op == "not" and isinstance(test.operand, facts.Name)):
        return False
    name = test.operand.id
    values = [
        statement.value
        for statement in _within(loop.body)
        if isinstance(statement, facts.Assign)
        and any(isinstance(target, facts.Name) and target.id == name for target in statement.targets)
    ]
    return bool(values) and all(_says(value, there=True) for value in values)


def _leaves(block: Sequence[facts.Stmt], *, unless_there: bool = False, inner: bool = False) -> bool:
    """Whether something in a loop's body may end the loop; with ``unless_there``, other than because the
    server is there.  ``inner`` is set within a loop inside, whose ``break`` ends that one only."""
    return any(_leaves_at(statement, unless_there, inner) for statement in block)


def _leaves_at(statement: facts.Stmt, unless_there: bool, inner: bool) -> bool:
    if isinstance(statement, facts.If):
        blocks = [statement.body, statement.orelse]
        if unless_there and _says(statement.test, there=True):
            blocks = [statement.orelse]
        elif unless_there and _says(statement.test, there=False):
            blocks = [statement.body]
        return _may_raise(statement.test) or any(
            _leaves(block, unless_there=unless_there, inner=inner) for block in blocks
        )
    if isinstance(statement, (facts.For, facts.While)):
        head = statement.iterable if isinstance(statement, facts.For) else statement.test
        return _may_raise(head) or _leaves(statement.body, unless_there=unless_there, inner=True)
    if isinstance(statement, (facts.Expression, facts.Assign)):
        return _may_raise(statement.value)
    if isinstance(statement, facts.Augmented):
        return _may_raise(statement.value)
    if isinstance(statement, facts.With):
        return _leaves(statement.body, unless_there=unless_there, inner=inner)
    if isinstance(statement, facts.Jump):
        return statement.kind == "break" and not inner
    return not isinstance(statement, (facts.Import, facts.ImportFrom, facts.Global))


def _leaves_when_there(block: Sequence[facts.Stmt]) -> bool:
    """Whether a body leaves its loop once the server is there."""
    for statement in block:
        if isinstance(statement, facts.If):
            there = statement.body if _says(statement.test, there=True) else []
            there = statement.orelse if _says(statement.test, there=False) else there
            if any(
                isinstance(part, facts.Return) or (isinstance(part, facts.Jump) and part.kind == "break")
                for part in there
            ):
                return True
    return False


def _may_raise(fact: facts.Base | None) -> bool:
    """Whether something calls what is no mere pastime."""
    return any(_called(call) not in _PASTIMES for call in calls_in(fact))


def _called(call: facts.Call) -> str:
    if isinstance(call.func, facts.Attribute):
        return call.func.attr
    return call.func.id if isinstance(call.func, facts.Name) else ""


def _within(block: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]:
    """The statements of a block and of the branches inside it."""
    for statement in block:
        yield statement
        if isinstance(statement, facts.If):
            yield from _within(statement.body)
            yield from _within(statement.orelse)
        elif isinstance(statement, (facts.With, facts.Try)):
            yield from _within(statement.body)
