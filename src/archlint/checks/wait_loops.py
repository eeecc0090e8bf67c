"""TMO004: loops that only the appearance of a service or an action server ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.reach import (
    calls_of,
    endpoint_words,
    has_limit,
    node_name,
    one_for_each_place,
)
from archlint.checks.registry import Options, finding, rule
from archlint.checks.timeouts import READY, WAIT_FOR_SERVER, WAIT_FOR_SERVICE, way_to
from archlint.facts import model as facts
from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.program.model import ApiCall
    from archlint.system.model import System

_ASKS = frozenset({"wait_for_service", "wait_for_server", "service_is_ready", "server_is_ready"})
"""Methods that tell whether a server is there."""

_PASTIMES = frozenset(
    {"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log", "print"}
    | {"sleep", "spin_once", "get_logger", "format", "str", "get_clock", "now", "sleep_for", "flush", "join"}
    | _ASKS
)
"""Calls of which none ends a loop; any other may raise, so a loop with one is not judged."""


@rule("TMO004")
def endless_wait_loop(system: System, options: Options) -> Iterator[Finding]:
    """Loops that go round until a server appears, and that nothing else ends."""
    yield from one_for_each_place(
        _endless(system, call)
        for _, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY))
        if (call.api in READY or has_limit(call, "timeout_sec")) and _only_the_server_ends(call)
    )


def _endless(system: System, call: ApiCall) -> Finding:
    kind = "action" if call.api.startswith("rclpy.action.") else "service"
    return finding(
        "TMO004",
        call.place,
        f"only the appearance of {endpoint_words(call.creation, kind)} ends this loop: without it the node "
        "never goes on",
        help="count the attempts or watch the clock, then do without it; a node that is of no use without it "
        "loops while rclpy.ok()",
        related=way_to(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, "" if call.creation is None else call.creation.name.text or "", "loop"),
    )


def _only_the_server_ends(call: ApiCall) -> bool:
    loop = call.loops[-1] if call.loops else None
    if not isinstance(loop, facts.While) or call.expression is None:
        return False
    if _asks(loop.test):
        return not _exits(loop.body, guarded=False)
    if isinstance(loop.test, facts.Literal) and loop.test.value:
        return not _exits(loop.body, guarded=True) and _leaves_when_there(loop.body)
    answer = _answer_variable(loop)
    return answer is not None and not _exits(loop.body, guarded=True)


def _asks(test: facts.Expr) -> bool:
    """Whether a condition depends on nothing but whether servers are there."""
    if isinstance(test, facts.Unary) and test.op == "not":
        return _asks(test.operand)
    if isinstance(test, facts.Boolean):
        return all(_asks(value) for value in test.values)
    if isinstance(test, facts.Compare):
        return _asks(test.left) and all(isinstance(other, facts.Literal) for other in test.comparators)
    if isinstance(test, facts.Assigned):
        return _asks(test.value)
    return isinstance(test, facts.Call) and isinstance(test.func, facts.Attribute) and test.func.attr in _ASKS


def _answer_variable(loop: facts.While) -> str | None:
    """The variable that a loop asks and that only an answer about a server sets: ``while not ready``."""
    test = loop.test
    if not (isinstance(test, facts.Unary) and test.op == "not" and isinstance(test.operand, facts.Name)):
        return None
    name = test.operand.id
    values = [
        statement.value
        for statement in _within(loop.body)
        if isinstance(statement, facts.Assign)
        and any(isinstance(target, facts.Name) and target.id == name for target in statement.targets)
    ]
    return name if values and all(_asks(value) for value in values) else None


def _exits(block: Sequence[facts.Stmt], guarded: bool) -> bool:
    """Whether something in a loop's body may end it; where ``guarded``, leaving because the server is there
    does not count."""
    return any(_exits_at(statement, guarded) for statement in block)


def _exits_at(statement: facts.Stmt, guarded: bool) -> bool:
    if isinstance(statement, facts.If):
        if guarded and _asks(statement.test):
            there = statement.orelse if _negated(statement.test) else statement.body
            other = statement.body if there is statement.orelse else statement.orelse
            return _exits(other, guarded) or any(_may_raise(part) for part in there)
        return _may_raise(statement.test) or _exits(statement.body, guarded) or _exits(statement.orelse, guarded)
    if isinstance(statement, facts.Expression):
        return _may_raise(statement.value)
    if isinstance(statement, facts.Assign):
        return _may_raise(statement.value)
    if isinstance(statement, facts.With):
        return _exits(statement.body, guarded)
    if isinstance(statement, facts.Jump):
        return statement.kind == "break"
    return not isinstance(statement, (facts.Import, facts.ImportFrom, facts.Global))


def _negated(test: facts.Expr) -> bool:
    return isinstance(test, facts.Unary) and test.op == "not"


def _leaves_when_there(block: Sequence[facts.Stmt]) -> bool:
    """Whether a body leaves its loop once the server is there."""
    for statement in block:
        if isinstance(statement, facts.If) and _asks(statement.test):
            there = statement.orelse if _negated(statement.test) else statement.body
            if any(isinstance(part, facts.Return) for part in there) or any(
                isinstance(part, facts.Jump) and part.kind == "break" for part in there
            ):
                return True
    return False


def _may_raise(fact: object) -> bool:
    """Whether something calls what is no mere pastime."""
    return any(_called(call) not in _PASTIMES for call in _calls_within(fact))


def _called(call: facts.Call) -> str:
    if isinstance(call.func, facts.Attribute):
        return call.func.attr
    return call.func.id if isinstance(call.func, facts.Name) else ""


def _calls_within(fact: object) -> Iterator[facts.Call]:
    stack = [fact]
    while stack:
        item = stack.pop()
        if isinstance(item, facts.Call):
            yield item
        if isinstance(item, (list, tuple)):
            stack.extend(item)
        elif isinstance(item, facts.Base):
            stack.extend(getattr(item, name) for name in item.__struct_fields__)


def _within(block: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]:
    """The statements of a block and of the branches inside it."""
    for statement in block:
        yield statement
        if isinstance(statement, facts.If):
            yield from _within(statement.body)
            yield from _within(statement.orelse)
        elif isinstance(statement, (facts.With, facts.Try)):
            yield from _within(statement.body)
