"""Calls that spin a node or an executor, and the nodes that more than one place spins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.reach import argument, judged_calls
from archlint.model import Role
from archlint.model.given import Node, Object

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System

_SPINS = ("rclpy.spin", "rclpy.spin_once", "rclpy.spin_until_future_complete")
_EXECUTOR = "rclpy.executors.Executor."
_EXECUTOR_SPINS = ("spin", "spin_once", "spin_until_future_complete", "spin_once_until_future_complete")
_AT_START = (Role.INIT, Role.MAIN, Role.MODULE)
"""Roles of what runs one after the other, on the thread that the program starts with."""


def is_spin_call(call: ApiCall) -> bool:
    """Whether a call spins a node or an executor."""
    return call.api in _SPINS or call.api in {_EXECUTOR + name for name in _EXECUTOR_SPINS}


def spun_node(call: ApiCall, program: Program) -> Blueprint | None:
    """The node that a spin runs, where there is one for certain."""
    if call.api.startswith(_EXECUTOR):
        use = None if call.receiver is None else call.receiver.executor
        nodes = [] if use is None else use.nodes
        return call.context.node if call.context.node in nodes else nodes[0] if len(nodes) == 1 else None
    value = argument(call, "node")
    options = [one for one in value.alternatives if isinstance(one, (Object, Node))] if value else []
    if len(options) != 1:
        return None
    if isinstance(options[0], Node):
        return options[0].blueprint
    return _blueprint_of(options[0], program)


def _blueprint_of(value: Object, program: Program) -> Blueprint | None:
    return next((node for node in program.nodes if node.key.endswith(f"#{value.key}")), None)


def spun_in_callbacks(system: System) -> set[int]:
    """The nodes (their ``id``) of callbacks that spin, and those that such callbacks spin."""
    found: set[int] = set()
    for program, call in judged_calls(system):
        if is_spin_call(call) and runs_in_executor(call.context):
            found |= {id(call.context.node), id(spun_node(call, program))}
    return found


def spun_by_several(system: System) -> set[int]:
    """The nodes (their ``id``) that more than one thread may spin: the program's own and one that it starts, or code
    of somebody else that is given a function which spins."""
    threads: dict[int, set[object]] = {}
    for program, call in judged_calls(system):
        if is_spin_call(call) and not runs_in_executor(call.context):
            node = spun_node(call, program)
            thread = "start" if call.context.role in _AT_START else call.context.place
            threads.setdefault(id(call.context.node if node is None else node), set()).add(thread)
    for program in system.programs:
        for use in program.executors:
            for node in use.nodes if use.in_thread else ():
                known = threads.setdefault(id(node), set())
                if known <= {"start"}:  # a thread whose target is the spin itself makes no call
                    known.add("thread")
    return {node for node, where in threads.items() if len(where) > 1}
