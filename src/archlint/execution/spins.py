"""Calls that spin a node or an executor, and the nodes that more than one place spins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.completeness import enclosing_function
from archlint.analysis.reach import argument, judged_calls
from archlint.execution.callback_roles import runs_in_executor
from archlint.model import ExecutorKind, Role, SpinDuration
from archlint.model.given import Node, Object
from archlint.python_code.endless_constructors import endless_classes
from archlint.syntax import facts
from archlint.syntax.control_flow import always_raises, graph_of
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, parts_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall, Blueprint, Callback, Program
    from archlint.systems.model import System

_SPINS = ("rclpy.spin", "rclpy.spin_once", "rclpy.spin_until_future_complete")
_EXECUTOR = "rclpy.executors.Executor."
METHODS_THAT_SPIN = ("spin", "spin_once", "spin_until_future_complete", "spin_once_until_future_complete")
_AT_START = (Role.INIT, Role.MAIN, Role.MODULE)
"""Roles of what runs one after the other, on the thread that the program starts with."""


def is_spin_call(call: ApiCall) -> bool:
    """Whether a call spins a node or an executor."""
    return call.api in _SPINS or call.api in {_EXECUTOR + name for name in METHODS_THAT_SPIN}


def spun_node(call: ApiCall, program: Program) -> Blueprint | None:
    """The node that a spin runs, where there is one for certain."""
    if call.api.startswith(_EXECUTOR):
        use = None if call.receiver is None else call.receiver.executor
        nodes = [] if use is None else use.nodes
        return call.context.node if call.context.node in nodes else nodes[0] if len(nodes) == 1 else None
    value = argument(call, "node")
    options = (
        [alternative for alternative in value.alternatives if isinstance(alternative, (Object, Node))] if value else []
    )
    if len(options) != 1:
        return None
    if isinstance(options[0], Node):
        return options[0].blueprint
    return _blueprint_of(options[0], program)


def _blueprint_of(value: Object, program: Program) -> Blueprint | None:
    return next((node for node in program.nodes if node.object_key == value.key), None)


def spun_in_callbacks(system: System) -> set[int]:
    """The nodes (their ``id``) of callbacks that spin, and those that such callbacks spin."""
    node_ids: set[int] = set()
    for program, call in judged_calls(system):
        if is_spin_call(call) and runs_in_executor(call.context):
            node_ids |= {id(call.context.node), id(spun_node(call, program))}
    return node_ids


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


KEPT_IN_HUMBLE_SINCE = "3.3.17"
"""The first rclpy of humble whose ``spin_once()`` leaves a node where it was."""


def is_dropped_in_humble(call: ApiCall, spun: Blueprint | None, program: Program) -> bool:
    """Whether a ``rclpy.spin_once(self)`` in a callback takes the node out of the executor that runs ``rclpy.spin()``:
    in humble it first removed the node afterwards, also one that was there before; ``rclpy.spin()`` adds it once.

    Source: rclpy/__init__.py, up to 3.3.16 of humble; 3.3.17, 7.1.5 of jazzy and 9.1.2 of kilted remove what they have
    added.
    """
    if call.api != "rclpy.spin_once" or spun is None or spun is not call.context.node or argument(call, "executor"):
        return False
    return any(other.api == "rclpy.spin" and spun_node(other, program) is spun for other in program.calls)


def is_left_to(call: ApiCall, spun: Blueprint | None, program: Program) -> bool:
    """Whether a callback spins another node than its own, and whoever else does so hands it over for that time only:
    no executor has the node, so its callbacks run in such spins or not at all."""
    if spun is None or spun is call.context.node or not call.api.startswith("rclpy.spin"):
        return False
    uses = [use for use in program.executors if spun in use.nodes]
    return is_spun_for_moments(spun, program) and all(spun in use.spells for use in uses)


def is_spun_in_sight(node: Blueprint) -> bool:
    """Whether it is known who spins a node: no code that is not read has it."""
    return not (node.caller_unknown or node.escapes) and node.executor != ExecutorKind.UNKNOWN


def is_spun_for_moments(spun: Blueprint, program: Program) -> bool:
    """Whether a node's callbacks, and the answers to its requests, are taken only while some call spins it for them:
    nothing runs them in between."""
    uses = [use for use in program.executors if spun in use.nodes]
    return not any(
        use.in_thread or use.lasts_for(spun) == SpinDuration.TO_THE_END or not (use.spun or spun in use.spells)
        for use in uses
    )


def spin_before(code: SourceCode, program: Program, place: Place) -> Place | None:
    """The ``rclpy.spin(…)`` that comes before a spin: it returns when ROS is shut down, not before."""
    later = next((call for call in program.calls if call.place == place), None)
    if later is None:
        return None
    endless = [call for call in program.calls if call.api == "rclpy.spin" and call.context.role == Role.MAIN]
    return next((call.place for call in endless if call.file == later.file and _comes_first(code, call, later)), None)


def _comes_first(code: SourceCode, call: ApiCall, later: ApiCall) -> bool:
    """Whether a later call is come to by way of another one, whatever raises, and ROS is not started anew between."""
    graph = graph_of(code.body(call))
    first = graph.evaluating(call.place.span)
    last = [block for block in graph.evaluating(later.place.span) if block not in first]
    if not last or not all(graph.dominates(first, block) for block in last):
        return False
    return all(
        called_name(inner_call) != "init" for block in graph.between(first, last) for inner_call in calls_in(block.fact)
    )


def is_never_spun_at_all(code: SourceCode, program: Program, node: Blueprint) -> bool:
    """Whether a program comes to no spin of a node, since a function that it calls before each never returns: the menu
    of ``start(robot)``, in front of ``rclpy.spin(robot)``, or the constructor of the node itself."""
    spells = [spell for use in program.executors if use.spun for spell in use.spells.get(node, ())]
    if _never_comes_to_be(code, node) and not any(_is_of_constructor(call) for call in program.calls):
        return True
    return bool(spells) and all(_is_behind_endless_call(code, program, spell.place) for spell in spells)


def is_spun_by_constructors_alone(program: Program, node: Blueprint) -> bool:
    """Whether an executable that is seen from end to end spins a node in constructors at most: once it is made, nothing
    takes in what comes for it."""
    seen = program.executable and not program.exhausted and node.complete
    if not seen or node.caller_unknown or node.escapes or node.runs_elsewhere:
        return False
    if node.executor == ExecutorKind.UNKNOWN or any(use.in_thread for use in program.executors_of(node)):
        return False
    return all(_is_of_constructor(call) for call in program.calls if is_spin_call(call))


def _is_of_constructor(call: ApiCall) -> bool:
    """Whether a constructor spins, be it in a method that it calls."""
    functions = (call.function, *(hop.caller for hop in call.chain))
    return is_spin_call(call) and any(name.rpartition(".")[2] == "__init__" for name in functions)


def _never_comes_to_be(code: SourceCode, node: Blueprint) -> bool:
    """Whether the constructor of a node never returns, and hands it to nobody else."""
    written = code.facts_at(node.place.file)
    is_seen = not (node.escapes or node.caller_unknown)
    return is_seen and written is not None and node.class_name in endless_classes(written)


def _is_behind_endless_call(code: SourceCode, program: Program, place: Place) -> bool:
    later = next((call for call in program.calls if call.place == place), None)
    written = None if later is None else code.facts_at(later.file)
    if later is None or written is None:
        return False
    endless = {each.name for each in written.body if isinstance(each, facts.Function) and always_raises(each.body)}
    graph = graph_of(code.body(later))
    spins = graph.evaluating(place.span)
    return bool(spins and endless) and any(
        not endless.isdisjoint(call.func.variable for call in calls_in(block.fact))
        and block not in spins
        and all(graph.dominates([block], spin) for spin in spins)
        for block in graph.blocks
    )


def spins_if_asked(system: System, program: Program, node: Blueprint, group: Place) -> bool:
    """Whether the function that makes a group would give the node an executor of its own, too, and did not here: it
    has an option for that, as ``TransformListener(…, spin_thread=True)``, and the group is for those who choose it."""
    made_by = None if system.workspace is None else enclosing_function(system.workspace, group)
    if made_by is None or "add_node" not in map(called_name, everything_in(made_by.body, facts.Call)):
        return False
    uses = [use for use in program.executors if node in use.nodes]
    places = [place for use in uses for place in (use.place, use.spins_at(node)) if place is not None]
    return not any(place.file == group.file and made_by.span[0] <= place.line <= made_by.span[2] for place in places)


def awaits(code: SourceCode, callback: Callback) -> bool:
    """Whether a callback awaits anything itself."""
    return any(parts_of(code.function(callback), facts.Await))
