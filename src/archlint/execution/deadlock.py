"""Whether a call that waits inside a callback can ever get its answer: which row of the matrix it is.

The rows are in :mod:`archlint.execution.blocking`; here the executor and the groups of a program are read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.execution.blocking import (
    ANY,
    AWAIT,
    CALL,
    LIMITED_CALL,
    LIMITED_SPIN,
    LIMITED_STEAL,
    NOBODY,
    ONE,
    OTHER,
    POOL_OF_ONE,
    REENTRANT,
    SAME,
    SEVERAL,
    SPIN,
    STEAL,
    TIMED_CALL,
    UNCLEAR,
    Outcome,
    Verdict,
    look_up,
)
from archlint.finding import Related
from archlint.model import (
    EntityKind,
    ExecutorKind,
    GroupKind,
    Role,
    SpinDuration,
)
from archlint.model.given import Constant
from archlint.ros.distros import DISTROS

if TYPE_CHECKING:
    from archlint.execution.blocking import Form, Relation, Threads
    from archlint.model.given import Constant
from archlint.model import ApiCall, Blueprint, Callback, Creation, ExecutorUse, Group, Program

__all__ = [
    "AWAIT",
    "CALL",
    "SPIN",
    "Verdict",
    "group_relation",
    "judge_wait",
    "related_executor",
    "threads_of",
]

_TIMED = "rclpy.client.Client.call"

_THREAD_BLOCKED = "the executor's only thread is blocked in this {who}, so the response is never processed"
_GROUP_BLOCKED = (
    "the client is in the mutually exclusive callback group of this {who}, so the response is not processed until "
    "the {who} returns"
)
_NO_SPIN = "nothing here spins the node with several threads, and a single thread is blocked while it waits"
_NO_EXECUTOR = "it is not known which executor spins the node"
_NO_GROUP = "it is not known which callback group the client is in"
_THREADS = "another thread processes the response, since the client is in another callback group"
_THREADS_REENTRANT = (
    "another thread processes the response, since the {who} and the client share a reentrant callback group"
)
_FREE = "the client is in another callback group, so the response is processed"
_FREE_REENTRANT = "the {who} and the client share a reentrant callback group, so the response is processed"
_NESTED = "its executor is already spinning"
_STOLEN = "its node is spun by another executor"
_STOLEN_FROM_US = "the executor that runs this callback already spins that node"
_OWN_SPIN = "a node with an executor of its own processes the response"


def judge_wait(
    kind: Form,
    call: ApiCall,
    client: Creation | None,
    program: Program,
    limited: bool = False,
    distros: Sequence[str] = DISTROS,
) -> Verdict:
    """What becomes of a wait of the callback ``call.context`` for the answer of ``client``."""
    callback = call.context
    if kind == SPIN:
        return judge_spin(call, None if client is None else client.node, client, program, limited, distros)
    node = callback.node
    form = _form(kind, call, limited)
    if client is not None and node is not None and client.node is not node:
        return _judge_two_nodes(form, node, client.node, program, distros)
    relation = group_relation(callback.group, client.group if client is not None else None)
    threads = threads_of(node, program)
    return look_up(form, threads, relation, _why(form, threads, relation, callback.role), distros)


def _form(kind: Form, call: ApiCall, limited: bool) -> Form:
    if kind != CALL or not limited:
        return kind
    return TIMED_CALL if call.api == _TIMED else LIMITED_CALL


def _why(form: Form, threads: Threads, relation: Relation, role: Role | None) -> str:
    who = "handler" if role == Role.SERVICE else "callback"
    if form == AWAIT:
        words = {SAME: _GROUP_BLOCKED, UNCLEAR: _NO_GROUP, REENTRANT: _FREE_REENTRANT}.get(relation, _FREE)
        return words.format(who=who)
    if threads == ONE:
        return _THREAD_BLOCKED.format(who=who)
    if relation == SAME and threads != NOBODY:
        return _GROUP_BLOCKED.format(who=who)
    if threads == SEVERAL:
        return {UNCLEAR: _NO_GROUP, REENTRANT: _THREADS_REENTRANT}.get(relation, _THREADS).format(who=who)
    return _NO_SPIN if threads == NOBODY else _NO_EXECUTOR


def threads_of(node: Blueprint | None, program: Program) -> Threads:
    """How many threads run a node's callbacks."""
    if node is None or node.executor == ExecutorKind.UNKNOWN:
        return ANY
    if node.executor == ExecutorKind.NONE:
        # What nothing starts may be spun by whoever makes it elsewhere.
        return NOBODY if program.executable and not node.caller_unknown else ANY
    uses = [use for use in program.executors_of(node) if use.kind == ExecutorKind.MULTI_THREADED]
    if node.executor == ExecutorKind.MULTI_THREADED:
        # Without a number there are as many threads as processors.
        return ONE if uses and all(use.threads == 1 for use in uses) else SEVERAL
    return ONE


def related_executor(node: Blueprint | None, program: Program) -> Iterator[Related]:
    """Where the executor of a node is made and spun."""
    if node is None:
        return
    for use in program.executors_of(node):
        place = use.spins_at(node) or use.place
        if place is not None:
            yield Related(place, f"{_executor_words(use)} spins the node")


def _executor_words(use: ExecutorUse) -> str:
    if use.kind == ExecutorKind.MULTI_THREADED:
        return "a MultiThreadedExecutor" + (f" with num_threads={use.threads}" if use.threads is not None else "")
    if use.kind == ExecutorKind.EVENTS:
        return "an EventsExecutor (one thread)"
    if use.kind == ExecutorKind.UNKNOWN:
        return "an unknown executor"
    return "a single-threaded executor"


def group_relation(group: Group | None, other: Group | None) -> Relation:
    """How the callback group of a callback and that of a client of the same node relate."""
    if group is None:
        return OTHER  # in no group: holds none
    if other is None or GroupKind.UNKNOWN in (group.kind, other.kind):
        return UNCLEAR
    if group.kind == other.kind == GroupKind.DEFAULT:
        return SAME
    if group.kind == other.kind and (group.key is None or group.key == other.key):
        return REENTRANT if group.kind == GroupKind.REENTRANT else UNCLEAR if group.key is None else SAME
    return OTHER


def _judge_two_nodes(
    form: Form, node: Blueprint, client: Blueprint, program: Program, distros: Sequence[str]
) -> Verdict:
    """The client belongs to another node: it matters who spins that one."""
    if form == AWAIT:
        return look_up(AWAIT, ANY, OTHER, _FREE, distros)
    spinners = program.executors_of(client)
    shared = [use for use in spinners if use in program.executors_of(node)]
    if not shared and any(use.in_thread for use in spinners):
        why = "another thread spins the client's node, so the response is processed"
        return look_up(form, SEVERAL, OTHER, why, distros)
    if not spinners:
        return look_up(form, ANY, OTHER, "nothing here spins the client's node during the wait", distros)
    threads = threads_of(node, program)
    return look_up(form, threads, OTHER, _why(form, threads, OTHER, None), distros)


def judge_spin(
    call: ApiCall,
    spun: Blueprint | None,
    client: Creation | None,
    program: Program,
    limited: bool = False,
    distros: Sequence[str] = DISTROS,
    on_global_executor: bool = False,
) -> Verdict:
    """A spin inside a callback ends well only for another node on an executor that is not running.  ``call`` may be the
    ``future.done()`` of a loop, which spins ``on_global_executor`` where it calls rclpy's functions."""
    callback = call.context
    node = callback.node
    running = program.executors_of(node) if node is not None else []
    relation = _relation_of_spin(call, spun, client)
    globally = on_global_executor or (call.api.startswith("rclpy.spin") and not _given(call, "executor"))
    form: Form = LIMITED_SPIN if limited else SPIN
    # A spin without a future ends as soon as there is any work.
    steal: Form = LIMITED_STEAL if limited or not (on_global_executor or "future" in call.arguments) else STEAL
    nested = look_up(form, _pool_of(node, program), relation, _NESTED, distros)
    if node is not None and any(creation.kind == EntityKind.ACTION_CLIENT for creation in node.creations):
        nested = nested.with_an_action_client()
    if globally and any(use.place is None for use in running):
        return nested
    if spun is None or node is None:
        return Verdict(dict.fromkeys(distros, Outcome.UNKNOWN), "it is not known which node is spun")
    if spun is not node:
        if globally and any(spun in use.nodes for use in running):
            return look_up(LIMITED_STEAL, ANY, relation, _STOLEN_FROM_US, distros)
        if not running or any(spun in use.nodes for use in running):
            return Verdict(
                dict.fromkeys(distros, Outcome.UNKNOWN), "it is not known whether its executor is already spinning"
            )
        return Verdict(dict.fromkeys(distros, Outcome.FINE), _OWN_SPIN)
    if (globally and running) or _on_one_of_its_own(call, node, running):
        return look_up(steal, ANY, relation, _STOLEN, distros)
    return nested


def _pool_of(node: Blueprint | None, program: Program) -> Threads:
    """The threads that run what a spin inside a callback finds to do."""
    threads = threads_of(node, program)
    pooled = node is not None and node.executor == ExecutorKind.MULTI_THREADED
    return POOL_OF_ONE if threads == ONE and pooled else threads


def _relation_of_spin(call: ApiCall, spun: Blueprint | None, client: Creation | None) -> Relation:
    """How the group of what a spin is for relates to that of the callback which spins."""
    callback = call.context
    if client is not None:
        other_node = callback.node is not None and client.node is not callback.node
        return OTHER if other_node else group_relation(callback.group, client.group)
    if callback.node is not None and spun is not None and spun is not callback.node:
        # A default group is the node's own; any other may be passed from node to node.
        shareable = callback.group is not None and callback.group.kind != GroupKind.DEFAULT
        return UNCLEAR if shareable and any(creation.group == callback.group for creation in spun.creations) else OTHER
    relation = group_relation(callback.group, None)
    if "future" not in call.arguments and relation == UNCLEAR and spun is not None:
        # What spins without a future waits for any work, and the group keeps out that of its own.
        return SAME if callback.group is not None and callback.group.kind != GroupKind.REENTRANT else OTHER
    return OTHER if relation == UNCLEAR and _no_client_shares_its_group(callback) else relation


_CLIENTS = frozenset({EntityKind.CLIENT, EntityKind.ACTION_CLIENT})


def _no_client_shares_its_group(callback: Callback) -> bool:
    """Whether the node of a callback has clients, all of them in groups that keep clear of the callback's: whichever of
    them has the future that the callback waits for."""
    node = callback.node
    if node is None or not node.complete or node.escapes:
        return False
    clients = [creation for creation in node.creations if creation.kind in _CLIENTS]
    return bool(clients) and all(group_relation(callback.group, client.group) == OTHER for client in clients)


def _on_one_of_its_own(call: ApiCall, node: Blueprint, running: Sequence[ExecutorUse]) -> bool:
    """Whether a spin is given an executor that runs the node for as long as this spin lasts, and no longer."""
    value = call.arguments.get("executor")
    use = None if value is None else value.executor
    if use is None or all(other is use for other in running):
        return False
    return use not in running or use.lasts_for(node) == SpinDuration.A_MOMENT


def _given(call: ApiCall, name: str) -> bool:
    value = call.arguments.get(name)
    return value is not None and not (isinstance(value, Constant) and value.value is None)
