"""Whether a call that waits inside a callback can ever get its answer: the executor's rules as data.

The answer to a request is an entity of the client's callback group.  It can be taken only while a thread of
the executor is free and that group is not held; a mutually exclusive group is held from a callback's start
until it has ended, also across ``await``.  The table was gained by running rclpy's own executors of all
supported distributions; they agree in it, but for the nested spin (see :data:`SPIN`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.program.model import ApiCall, Blueprint, Creation, ExecutorUse, Group, Program

CALL = "call"
"""The thread stands still until the answer is there: ``call``, ``send_goal``, a loop, an event."""
AWAIT = "await"
"""The callback is put aside until the answer is there; the thread is free meanwhile."""
SPIN = "spin"
"""The callback spins the node itself."""

ONE = "one thread"
SEVERAL = "several threads"
NOBODY = "nobody seen to spin it"
ANY = "executor not known"

SAME = "same group"
OTHER = "other group"
REENTRANT = "reentrant group"
UNCLEAR = "group not known"


@dataclass(frozen=True)
class Verdict:
    """Whether the wait is proved to end, and why (not) in words that follow "…: "."""

    safe: bool
    why: str


_ONE_HELD = "the executor has one thread, and the handler holds it, so the answer cannot be taken"
_GROUP_HELD = "the handler holds the mutually exclusive group of the client, so the answer cannot be taken"
_NO_SPIN = "nothing here spins the node with several threads, and one thread cannot wait for itself"
_NO_EXECUTOR = "it is not known which executor spins the node"
_NO_GROUP = "it is not known which callback group the client is in"
_THREADS = "several threads and a group apart let the answer in"
_FREE = "the client is in a group apart, so the answer is let in"

TABLE: dict[tuple[str, str, str], Verdict] = {
    **{(CALL, threads, SAME): Verdict(False, _GROUP_HELD) for threads in (SEVERAL, ANY)},
    (CALL, SEVERAL, OTHER): Verdict(True, _THREADS),
    (CALL, SEVERAL, REENTRANT): Verdict(True, _THREADS),
    (CALL, SEVERAL, UNCLEAR): Verdict(False, _NO_GROUP),
    **{(CALL, ANY, group): Verdict(False, _NO_EXECUTOR) for group in (OTHER, REENTRANT, UNCLEAR)},
    **{(CALL, ONE, group): Verdict(False, _ONE_HELD) for group in (SAME, OTHER, REENTRANT, UNCLEAR)},
    **{(CALL, NOBODY, group): Verdict(False, _NO_SPIN) for group in (SAME, OTHER, REENTRANT, UNCLEAR)},
    **{(AWAIT, threads, SAME): Verdict(False, _GROUP_HELD) for threads in (ONE, SEVERAL, NOBODY, ANY)},
    **{(AWAIT, threads, OTHER): Verdict(True, _FREE) for threads in (ONE, SEVERAL, NOBODY, ANY)},
    **{(AWAIT, threads, REENTRANT): Verdict(True, _FREE) for threads in (ONE, SEVERAL, NOBODY, ANY)},
    **{(AWAIT, threads, UNCLEAR): Verdict(False, _NO_GROUP) for threads in (ONE, SEVERAL, NOBODY, ANY)},
}

_NESTED = "its executor is spinning already, so this raises, hangs or takes the node away from it"
_OWN_SPIN = "a node and an executor of its own let the answer in"


def judge_wait(kind: str, call: ApiCall, client: Creation | None, program: Program) -> Verdict:
    """Whether a wait of the callback ``call.context`` for the answer of ``client`` is proved to end."""
    handler = call.context
    if kind == SPIN:
        return _judge_spin(call, client, program)
    if client is not None and handler.node is not None and client.node is not handler.node:
        return _judge_two_nodes(kind, handler.node, client.node, program)
    relation = group_relation(handler.group, client.group if client is not None else None)
    return TABLE[kind, threads_of(handler.node, program), relation]


def threads_of(node: Blueprint | None, program: Program) -> str:
    """How many threads run a node's callbacks."""
    if node is None or node.executor == "unknown":
        return ANY
    uses = [use for use in executors_of(node, program) if use.kind == "multi_threaded"]
    if node.executor == "multi_threaded":
        # Without a number there are as many threads as processors.
        return ONE if uses and all(use.threads == 1 for use in uses) else SEVERAL
    return NOBODY if node.executor == "none" else ONE


def executors_of(node: Blueprint, program: Program) -> list[ExecutorUse]:
    """The executors that spin a node."""
    return [use for use in program.executors if use.spun and node in use.nodes]


def group_relation(one: Group | None, other: Group | None) -> str:
    """How the callback group of a callback and that of a client of the same node relate."""
    if one is None:
        return OTHER  # in no group: holds none
    if other is None or "unknown" in (one.kind, other.kind):
        return UNCLEAR
    if one.kind == other.kind == "default":
        return SAME
    if one.kind == other.kind and (one.key is None or one.key == other.key):
        return REENTRANT if one.kind == "reentrant" else UNCLEAR if one.key is None else SAME
    return OTHER


def _judge_two_nodes(kind: str, handler: Blueprint, client: Blueprint, program: Program) -> Verdict:
    """The client belongs to another node: it matters who spins that one."""
    if kind == AWAIT:
        return Verdict(True, _FREE)
    spinners = executors_of(client, program)
    shared = [use for use in spinners if use in executors_of(handler, program)]
    if not shared and any(use.in_thread for use in spinners):
        return Verdict(True, "another thread spins the client's node, so the answer is let in")
    if not spinners:
        return Verdict(False, "nothing here spins the client's node meanwhile")
    return TABLE[kind, threads_of(handler, program), OTHER]


def _judge_spin(call: ApiCall, client: Creation | None, program: Program) -> Verdict:
    """A spin inside a callback ends well only for another node on an executor that is not running."""
    handler = call.context.node
    if client is None or handler is None or client.node is handler:
        return Verdict(False, _NESTED)
    running = executors_of(handler, program)
    if call.api.startswith("rclpy.spin") and not _given(call, "executor"):
        globally = any(use.place is None for use in running)
        return Verdict(False, _NESTED) if globally or not running else Verdict(True, _OWN_SPIN)
    shared = any(client.node in use.nodes for use in running)
    return Verdict(False, _NESTED) if shared or not running else Verdict(True, _OWN_SPIN)


def _given(call: ApiCall, name: str) -> bool:
    value = call.arguments.get(name)
    return value is not None and getattr(value, "value", value) is not None
