"""Waits of which the code says that it waits."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.order import always_comes_before
from archlint.analysis.reach import creations_of, waits_for_ever
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.blocking import SEVERAL
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.kept_waiting import blocks_nobody
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import everything_in, parts_of
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_SAYS = frozenset({"info", "warn", "warning", "error", "print"})
_ASKS = frozenset({"service_is_ready", "server_is_ready"})
"""What tells whether there is anything to wait for."""
_WAITS = frozenset({"wait_for_service", "wait_for_server"})
_ENDS = frozenset({"shutdown", "try_shutdown", "destroy_node", "destroy", "exit", "get_logger", "set", "join"})
"""What is called in every ``except KeyboardInterrupt`` that ends a program."""


def is_announced_start(system: System, call: ApiCall) -> bool:
    """Whether a program starts with a wait of which the line before tells: whoever reads its log knows what is
    missing."""
    return call.context.role in (Role.INIT, Role.MAIN, Role.MODULE) and _is_announced(source_code(system), call)


def is_announced_beside_others(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a callback tells that it waits, and other threads run everything else meanwhile."""
    callback = call.context
    several = runs_in_executor(callback) and threads_of(callback.node, program) == SEVERAL
    return several and blocks_nobody(callback, program) and _is_announced(source_code(system), call)


def is_documented_start(system: System, call: ApiCall) -> bool:
    """Whether a comment above a wait, or the docstring of the function around it or of a constructor that leads there,
    says that a program waits as it starts: that is the order in which the author wants things to come up."""
    code = source_code(system)
    function = code.function_at(call.place)
    workspace = system.workspace
    if call.context.role not in (Role.INIT, Role.MAIN, Role.MODULE) or function is None or workspace is None:
        return False
    above = workspace.tree.lines(call.file, function.span[0] + 1, call.place.line - 1)
    comments = (line.partition("#")[2] for line in above if "#" in line)
    callers = (code.function_at(frame.place) for frame in call.chain)
    constructors = (caller.docstring for caller in callers if caller is not None and caller.name == "__init__")
    return any(map(_TELLS.search, (function.docstring, *constructors, *comments)))


_TELLS = re.compile(
    r"\b(?:waits?|waiting|wartet?|warten|attend(?:re)?|espera[rn]?|aspetta(?:re)?|blocks until)\b(?![(.])"
    r"|\b(?:ensures?|ensuring|make sure|makes sure)\b[^.]*\b(?:is|are) (?:up|there|ready|running|available)\b"
    r"|等待|待つ|待機|대기|기다",
    re.IGNORECASE,
)
"""Words for waiting, or for what has to be there first, and no call of a function whose name has one."""


def is_start_in_order(program: Program, call: ApiCall) -> bool:
    """Whether the constructor around a wait also waits for a service that is there to be waited for: its name says that
    its node is ready, and nobody asks it for anything.  So its author wants things to come up in this order."""
    requests = (other for other in program.calls if other.api in _REQUESTS)
    asked = {client.place for request in requests for client in creations_of(request.receiver)}
    return call.context.role in (Role.INIT, Role.MAIN) and any(
        client.type == _TRIGGER and client.place not in asked and _READY.search(client.name.text or "")
        for other in program.calls
        if other.api == call.api and (other.function, other.file) == (call.function, call.file)
        for client in creations_of(other.receiver)
    )


_TRIGGER = "std_srvs/srv/Trigger"
_REQUESTS = frozenset({"rclpy.client.Client.call", "rclpy.client.Client.call_async"})
_READY = re.compile(
    r"(?:^|[/_])(?:ready|(?:init(?:iali[sz]ation)?|start(?:up)?|boot)_(?:finish|finished|done|complete|completed|ready))$"
)
"""The end of a name such as ``/arm/init_finish``."""


def is_ended_by_hand(system: System, call: ApiCall) -> bool:
    """Whether the function around a wait has a way of its own for Ctrl-C, which takes back what it has asked for: that
    is how whoever runs the program ends the wait."""
    at = call.place.line, call.place.column
    for tried in everything_in(source_code(system).body(call), facts.Try):
        inside = bool(tried.handlers) and tried.span[:2] <= at < tried.handlers[0].span[:2]
        if inside and any(_takes_back(row) for row in tried.handlers if "KeyboardInterrupt" in row.caught):
            return True
    return False


def _takes_back(handler: facts.Handler) -> bool:
    return any(called_name(call) not in _SAYS | _ENDS for call in calls_in(handler.body))


def is_second_wait(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a program that comes to a wait on its own way has waited there for the same server before, until it was
    there: without a limit, or in a loop that asks for it again."""
    code, clients = source_code(system), {client.place for client in creations_of(call.receiver)}
    if not clients or call.context.role not in _ON_ITS_WAY:
        return False
    return any(
        other.api == call.api
        and other.place != call.place
        and {client.place for client in creations_of(other.receiver)} == clients
        and _ends_with_the_server(code, other)
        and (always_comes_before(code, other, call) or (_is_in_constructor(other) and not _is_in_constructor(call)))
        for other in program.calls
    )


_ON_ITS_WAY = frozenset({Role.INIT, Role.MAIN, Role.MODULE})


def _ends_with_the_server(code: SourceCode, call: ApiCall) -> bool:
    """Whether a wait is over only once the server is there: ``while not client.wait_for_service(timeout_sec=1.0):``"""
    loop = code.loop(call)
    if waits_for_ever(code, call, "timeout_sec", negative=False):
        return True
    match loop:
        case facts.While(test=facts.Unary(op="not", operand=facts.Call(span=span))):
            jumps = any(part.kind == "break" for part in parts_of(loop.body, facts.Jump))
            return span == call.place.span and not jumps and not any(parts_of(loop.body, facts.Return))
    return False


def _is_in_constructor(call: ApiCall) -> bool:
    functions = (call.function, *(hop.caller for hop in call.chain))
    return any(name.rpartition(".")[2] == CONSTRUCTOR for name in functions)


def says_something(loop: facts.While | facts.For | None) -> bool:
    """Whether each round of a loop may write to the log or to the terminal: whoever looks sees what it waits for."""
    return loop is not None and any(called_name(call) in _SAYS for call in calls_in(loop.body))


def _is_announced(code: SourceCode, call: ApiCall) -> bool:
    """Whether on every way to a call a line says something, and since then there are only assignments, other waits and
    the question whether the server is there; or a line before that says that it waits."""
    if any(_says_so(statement.value) and statement.span < call.place.span for statement in _expressions(code, call)):
        return True

    def step(said: bool, fact: facts.Base) -> bool:
        match fact:
            case facts.Expression(value=facts.Call() as called):
                # What is waited for next is part of the same start, of which the line before has told.
                return called_name(called) in _SAYS or (said and called_name(called) in _WAITS)
            case facts.Assign():
                return said
            case facts.Unary(operand=facts.Call() as asked) | (facts.Call() as asked):
                return said and called_name(asked) in _ASKS
        return False

    graph = graph_of(code.body(call))
    waits, states = graph.evaluating(call.place.span), graph.states(False, step)
    return bool(waits) and all(states.get(block) == frozenset({True}) for block in waits)


def _expressions(code: SourceCode, call: ApiCall) -> list[facts.Expression]:
    """The statements of the function around a call, those of its branches left out, that are expressions."""
    return [statement for statement in code.body(call) if isinstance(statement, facts.Expression)]


def _says_so(e: facts.Expr) -> bool:
    """``self.get_logger().info('Waiting for the arm')``"""
    if not isinstance(e, facts.Call) or called_name(e) not in _SAYS:
        return False
    texts = [part.text or "" for argument in e.args for part in everything_in(argument.value, facts.Literal)]
    return any("waiting" in text.lower() for text in texts)


__all__ = [
    "is_announced_beside_others",
    "is_announced_start",
    "is_documented_start",
    "is_ended_by_hand",
    "is_second_wait",
    "is_start_in_order",
    "says_something",
]
