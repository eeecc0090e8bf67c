"""Who waits while a callback keeps its thread: what else its executor would run meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum, auto
from typing import TYPE_CHECKING

from archlint.execution import blocking
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.own_buffers import fills_what_is_read_before, is_of_listener
from archlint.model import EntityKind, ExecutorKind, Group, GroupKind, Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall, Blueprint, Callback, Creation, Program


class Waiting(Enum):
    """Who has to wait."""

    OTHERS = auto()
    """Other callbacks, which are known."""
    SELDOM = auto()
    """Only timers, which seldom run."""
    NOBODY = auto()
    """Only the next turn of the same callback."""
    UNKNOWN = auto()


_FOR_SERVER = "rclpy.action.client.ActionClient.wait_for_server"
_FOR_SERVICE = "rclpy.client.Client.wait_for_service"
_RUNS_AGAIN = frozenset({Role.SUBSCRIPTION, Role.TIMER, Role.SERVICE, Role.EXECUTE, Role.DONE})
"""What is called again and again, so that its next turn waits; with an answer, once for each request."""
_TAKE_IN = frozenset(
    {EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.ACTION_SERVER, EntityKind.TIMER, EntityKind.GUARD_CONDITION}
)
"""Kinds of entities that bring an executor work by themselves."""


def blocks_nobody(callback: Callback, program: Program) -> bool:
    """Whether nothing else has to wait while a callback runs: other threads take the work that is in other groups."""
    threads = threads_of(callback.node, program)
    if threads != blocking.SEVERAL:
        # What holds no group is harmless under several threads, and nobody says that there are none.
        return callback.group is None and threads in (blocking.ANY, blocking.NOBODY)
    group = callback.group
    if group is None or group.kind == GroupKind.REENTRANT:
        return True
    if group.kind != GroupKind.MUTUALLY_EXCLUSIVE or callback.node is None:
        return False
    others = [other for other in callback.node.callbacks if other.group == group and other.place != callback.place]
    return not others


def who_waits(code: SourceCode, call: ApiCall, program: Program, *, but_listeners: bool = False) -> Waiting:
    """Who waits while a callback keeps its thread in a call, transform listeners left out with ``but_listeners``."""
    callback = call.context
    node = callback.node
    if node is None:
        return Waiting.UNKNOWN
    nodes, besides = _spun_with(node, program), waits_besides(code, call, program)
    others = [each for each in besides if not but_listeners or each is None or not is_of_listener(code, each)]
    if others:
        return Waiting.SELDOM if all(map(_runs_seldom, others)) else Waiting.OTHERS
    # The transitions of a lifecycle node wait, too, if anybody asks for one.
    known = callback.role in _RUNS_AGAIN and not node.lifecycle
    known_executor = known and node.executor in (ExecutorKind.SINGLE_THREADED, ExecutorKind.MULTI_THREADED)
    return Waiting.NOBODY if known_executor and all(spun.complete for spun in nodes) else Waiting.UNKNOWN


def keeps_intake_alone(code: SourceCode, call: ApiCall, program: Program) -> bool:
    """Whether all that has to wait are timers that seldom run, and subscriptions that only keep what they are given."""
    others = waits_besides(code, call, program)
    return bool(others) and all(_runs_seldom(creation) or _only_keeps(code, creation) for creation in others)


def waits_besides(code: SourceCode, call: ApiCall, program: Program) -> list[Creation | None]:
    """What gives the executors of a callback's node anything to do besides it, for all nodes that they run."""
    node = call.context.node
    nodes = [] if node is None else _spun_with(node, program)
    if threads_of(node, program) == blocking.SEVERAL and call.context.group == Group():
        nodes = nodes[:1]  # each node has a default group of its own
    return [creation for spun in nodes for creation in _taken_in_besides(code, spun, call, program)]


def _spun_with(node: Blueprint, program: Program) -> list[Blueprint]:
    """A node, and the others that its executors run."""
    return [node, *(other for use in program.executors_of(node) for other in use.nodes if other is not node)]


def is_one_chain(call: ApiCall, program: Program) -> bool:
    """Whether all that a node does begins with one and the same callback, of no timer, and comes of it: the done
    callbacks of its requests, and theirs.  None of them could go on before a server is found that it looks for."""
    node = call.context.node
    if node is None or node.lifecycle or not node.complete:
        return False
    if any(other is not node for use in program.executors_of(node) for other in use.nodes):
        return False
    begins = [creation for creation in node.creations if creation.kind in _TAKE_IN and not creation.destroyed]
    follows = (Role.DONE, Role.FEEDBACK)
    own = {creation.place for creation in begins}
    return (
        len(own) == 1
        and begins[0].kind != EntityKind.TIMER
        and all(
            callback.role in follows or callback.creation in begins
            for callback in node.callbacks
            if runs_in_executor(callback)
        )
    )


_SELDOM = 0.5
"""Seconds of a timer's period from which on nobody notices that it is late: it controls nothing."""


def _runs_seldom(creation: Creation | None) -> bool:
    return creation is not None and creation.period is not None and creation.period >= _SELDOM


def _only_keeps(code: SourceCode, creation: Creation | None) -> bool:
    """Whether a subscription does no more than keep what it is given: the next message comes soon enough."""
    if creation is None or creation.kind != EntityKind.SUBSCRIBER or not creation.callbacks:
        return False
    functions = [code.function(handler) for handler in creation.callbacks.values()]
    return all(isinstance(function, facts.Function) and _sets_values(function) for function in functions)


_CONVERTS = frozenset({"bool", "float", "int", "list", "round", "str", "tuple", "array", "asarray", "copy", "deepcopy"})


def _sets_values(function: facts.Function) -> bool:
    sets = all(isinstance(statement, facts.Assign) or _is_docstring(statement) for statement in function.body)
    return sets and {called_name(call) for call in calls_in(function.body)} <= _CONVERTS


def _is_docstring(statement: facts.Stmt) -> bool:
    return isinstance(statement, facts.Expression) and isinstance(statement.value, facts.Literal)


def _taken_in_besides(code: SourceCode, node: Blueprint, call: ApiCall, program: Program) -> Iterator[Creation | None]:
    """What gives an executor anything to do for a node besides one callback, None for callbacks of nothing that is
    known.  What a node sends is no work, nor is the answer that nothing is registered for, nor what the callback makes
    only after it has waited."""
    callback = call.context
    later = {id(creation) for creation in node.creations if _is_made_after(creation, call)}
    follow = _callbacks_that_follow(code, node, call)
    several_threads = threads_of(callback.node, program) == blocking.SEVERAL
    looks_for_server = call.api in (_FOR_SERVER, _FOR_SERVICE)  # its answers are judged by what follows
    for creation in node.creations:
        if creation.kind not in _TAKE_IN or creation.destroyed or creation is callback.creation:
            continue
        if id(creation) in later or (several_threads and creation.group != callback.group):
            continue
        handlers = creation.callbacks.values()
        if handlers and all(handler.place == callback.place for handler in handlers):
            continue
        if not fills_what_is_read_before(code, creation, call, program):
            yield creation
    for other in node.callbacks:
        if several_threads and other.group != callback.group:
            continue
        if other.place == callback.place or other in follow or id(other.creation) in later:
            continue
        if other.creation is callback.creation and other.role != Role.CANCEL:
            continue
        if other.role == Role.DONE and not looks_for_server and _only_reports(code, other):
            continue
        if other.role != Role.LIFECYCLE and runs_in_executor(other):
            yield other.creation


_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal", "print"})
_LOOKS = frozenset({"get_logger", "result", "exception", "done", "str", "len", "format", "round", "float"})


def _only_reports(code: SourceCode, callback: Callback) -> bool:
    """Whether all that a callback does is to log what has come of a request: nobody misses it for a while."""
    function = code.function(callback)
    body = [] if function is None else function.body if isinstance(function, facts.Function) else [function.body]
    calls = {called_name(call) for call in calls_in(body)}
    changes = any(not target.variable for part in everything_in(body) for target in part.assigned)
    return not changes and not calls.isdisjoint(_LOGS) and calls <= _LOGS | _LOOKS


def _is_made_after(creation: Creation, call: ApiCall) -> bool:
    """Whether the function that waits makes something further down."""
    same = (creation.place.file, creation.function) == (call.file, call.function)
    return same and creation.context is call.context and not call.loops and creation.place > call.place


def _callbacks_that_follow(code: SourceCode, node: Blueprint, call: ApiCall) -> list[Callback]:
    """The done callbacks of futures that the waiting function makes further down, and of those that these make; while
    it waits for an action server, the feedback of goals that it sends further down: nobody is there to give any."""
    follow: list[Callback] = []
    roles = {Role.DONE, Role.FEEDBACK} if call.api == _FOR_SERVER else {Role.DONE}
    rest = [callback for callback in node.callbacks if callback.role in roles and callback.registered is not None]
    body = [] if call.loops else code.body(call)
    span = getattr(body[-1], "span", None) if body else None
    bodies = [] if span is None else [(call.place, span[2])]
    while bodies:
        start, end = bodies.pop()
        for follower in [callback for callback in rest if _is_between(callback.registered, start, end)]:
            rest.remove(follower)
            follow.append(follower)
            function = code.function(follower)
            if function is not None:
                bodies.append((follower.place, function.span[2]))
    return follow


def _is_between(place: Place | None, start: Place, end_line: int) -> bool:
    return place is not None and place.file == start.file and place > start and place.line <= end_line


__all__ = ["Waiting", "blocks_nobody", "is_one_chain", "keeps_intake_alone", "waits_besides", "who_waits"]
