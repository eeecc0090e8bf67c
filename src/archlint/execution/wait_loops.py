"""Loops that wait for a server: whether anything but its appearance ends them."""

from __future__ import annotations

from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.flow_blocks import Block, Edge, Kind, Loop, reach, without_exceptions
from archlint.syntax.walk import called_name, calls_in, statements_of

_ASKS = frozenset({"wait_for_service", "wait_for_server", "service_is_ready", "server_is_ready"})
"""Methods that say whether a server is there."""

_PASTIMES = frozenset(
    {"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log", "print"}
    | {"sleep", "spin_once", "get_logger", "get_clock", "now", "sleep_for", "flush", "format", "join"}
    | {"str", "len", "range", "time", "monotonic"}
    | _ASKS
)
"""Calls of which none ends a loop; any other may raise, so a loop with one is not judged."""


def only_the_server_ends(statement: facts.While | facts.For | None) -> bool:
    """Whether a loop repeats until a server is there, and nothing else ends it: ``while not client.wait_for_service(
    timeout_sec=1.0)``, or ``while True`` with such a test that leaves it."""
    if not isinstance(statement, facts.While):
        return False
    loop = loop_of(statement)
    if _says(statement.test, there=False):
        return not _may_end(loop, there=True)
    if statement.is_endless:
        return _leaves_when_there(loop) and not _may_end(loop, there=False)
    return _asks_a_variable(statement) and not _may_end(loop, there=False)


@dataclass(frozen=True)
class LoopEnd:
    """The servers whose appearance ends a loop, by the places of the calls that look for them."""

    spans: frozenset[facts.Span]
    any_of_them: bool
    """Whether one of them is enough."""


def end_of(statement: facts.While | facts.For | None) -> LoopEnd | None:
    """Which servers end such a loop; None for another loop, where several conditions decide, or where some of the
    servers are enough, and others are not."""
    tests = _tests_of(statement) if isinstance(statement, facts.While) else []
    if len(tests) != 1:
        return None
    [(test, there)] = tests
    asking = _asking(test)
    enough = True if len(asking) == 1 else _is_one_enough(test, there)
    return None if enough is None else LoopEnd(frozenset(call.span for call in asking), enough)


def _tests_of(statement: facts.While) -> list[tuple[facts.Expr, bool]]:
    """The conditions about servers that decide on a loop, each with whether it holds while they are there."""
    if _says(statement.test, there=False):
        return [(statement.test, False)]
    if not statement.is_endless:
        values = [assignment.value for assignment in statements_of(statement.body, facts.Assign)]
        return [(value, True) for value in values if _says(value, there=True)]
    tests = [choice.test for choice in statements_of(statement.body, facts.If)]
    return [(test, there) for test in tests for there in (True, False) if _says(test, there)]


def _asking(test: facts.Expr) -> list[facts.Call]:
    return [call for call in calls_in(test) if call.func.attribute in _ASKS]


def _is_one_enough(test: facts.Expr, there: bool) -> bool | None:
    """Whether one server is enough for a condition that holds while they are there, or (``there`` false) are missing;
    None where that depends on which."""
    match test:
        case facts.Unary(op="not"):
            return _is_one_enough(test.operand, not there)
        case facts.Assigned():
            return _is_one_enough(test.value, there)
        case facts.Boolean() if all(len(_asking(value)) == 1 for value in test.values):
            return (test.op == "or") is there
    return None


def _says(test: facts.Expr, there: bool) -> bool:
    """Whether a condition holds just as long as servers are there, or (``there`` false) are missing."""
    match test:
        case facts.Unary(op="not"):
            return _says(test.operand, not there)
        case facts.Boolean():
            return all(_says(value, there) for value in test.values)
        case facts.Compare(ops=["==" | "is"], comparators=[facts.Literal(value=bool(wanted))]):
            return _says(test.left, there if wanted else not there)
        case facts.Assigned():
            return _says(test.value, there)
        case facts.Call():
            return there and test.func.attribute in _ASKS
    return False


def _may_end(loop: Loop, there: bool) -> bool:
    """Whether something in the body of a loop may end it, be it by raising; unless it may be ``there``, only what runs
    while the server is missing counts."""

    def along(edge: Edge) -> bool:
        if edge.kind is Kind.RAISE:
            return False
        return there or edge.test is None or not _says(edge.test, there=edge.holds)

    starts = [edge.target for edge in loop.head.edges if edge.holds and edge.kind is not Kind.RAISE]
    return any(loop not in block.loops or _may_raise(block) for block in reach(starts, along, avoiding=[loop.head]))


def _may_raise(block: Block) -> bool:
    """Whether a block calls what is no mere pastime, or is more than a plain statement."""
    match block.statement:
        case None | facts.With():
            return False
        case facts.If() | facts.For() | facts.While() | facts.Expression() | facts.Assign() | facts.Augmented():
            return any(called_name(call) not in _PASTIMES for call in calls_in(block.fact))
        case facts.Jump() | facts.Import() | facts.ImportFrom() | facts.Global():
            return False
    return True


def _leaves_when_there(loop: Loop) -> bool:
    """Whether a body leaves its loop once the server is there."""
    there = [
        edge.target
        for block in loop.blocks
        for edge in block.edges
        if edge.test is not None and _says(edge.test, there=edge.holds)
    ]
    return any(loop not in block.loops for block in reach(there, without_exceptions, avoiding=[loop.head]))


def _asks_a_variable(loop: facts.While) -> bool:
    """``while not ready``, where nothing in the loop but an answer about a server sets ``ready``."""
    match loop.test:
        case facts.Unary(op="not", operand=facts.Name(id=name)):
            assigned = [
                assignment
                for assignment in statements_of(loop.body, facts.Assign)
                if name in [target.variable for target in assignment.targets]
            ]
            return bool(assigned) and all(_says(assignment.value, there=True) for assignment in assigned)
    return False


__all__ = ["LoopEnd", "end_of", "only_the_server_ends"]
