"""Executors: which one spins which node, and with how many threads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import Instance, Known, OneOf, Value
from archlint.libraries.rclpy import made_nodes, nodes
from archlint.libraries.rclpy.fields import EXECUTOR
from archlint.libraries.values import ExecutorValue, FutureValue
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.parts import once_for
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.libraries.tables import Api

_STARTED = (model.Role.INIT, model.Role.MAIN, model.Role.MODULE, model.Role.THREAD, model.Role.METHOD)
"""Roles of what no executor runs."""


def make_executor(run: Run, call: ApiUse) -> Value:
    use = _new_use(run, call.api.executor, call.get("num_threads"), call)
    return ExecutorValue(use, call.api.path, run.store.new_key())


def adopt_executor(run: Run, api: Api, receiver: Instance, site: CallSite) -> Value:
    """An executor class of ours: ``super().__init__()`` says which kind it is."""
    threads = site.keywords.get("num_threads", site.args[0] if site.args else None)
    run.store.set(receiver.key, EXECUTOR, _new_use(run, api.executor, threads, None))
    return Known(None)


def _new_use(
    run: Run, kind: model.ExecutorKind | None, threads: Value | None, call: ApiUse | None
) -> model.ExecutorUse:
    count = None if threads is None else threads.whole_number
    if kind in (model.ExecutorKind.SINGLE_THREADED, model.ExecutorKind.EVENTS):
        count = 1
    place = run.place(call.expression.span) if call is not None and call.expression is not None else None
    use = model.ExecutorUse(kind or model.ExecutorKind.UNKNOWN, count, [], place)
    run.program.executors.append(use)
    return use


def use_of(run: Run, value: Value | None) -> model.ExecutorUse | None:
    match value:
        case ExecutorValue(use=use):
            return use
        case Instance(key=key):
            return run.store.get(key, EXECUTOR)
        case OneOf(values=options):
            uses = [use for use in (use_of(run, option) for option in options) if use is not None]
            return uses[0] if len(uses) == 1 else None
    return None


def _global_use(run: Run) -> model.ExecutorUse:
    """The process-wide single-threaded executor of ``rclpy.spin``."""
    for use in run.program.executors:
        if use.place is None and use.kind == model.ExecutorKind.SINGLE_THREADED:
            return use
    use = model.ExecutorUse(model.ExecutorKind.SINGLE_THREADED, 1, [], None)
    run.program.executors.append(use)
    return use


def _put(run: Run, use: model.ExecutorUse, node: model.Blueprint) -> None:
    use.spells.pop(node, None)
    for other in run.program.executors:
        if node in other.spells:
            other.spells[node] = [replace(spell, taken_from=None) for spell in other.spells[node]]
    if node not in use.nodes:
        use.nodes.append(node)


def settle(program: model.Program) -> None:
    """Say of each node which kind of executor serves it, once all of them are known."""
    astray = any(use.kind == model.ExecutorKind.UNKNOWN and use.spun and not use.nodes for use in program.executors)
    for node in program.nodes:
        kinds = {
            model.ExecutorKind.SINGLE_THREADED if use.kind == model.ExecutorKind.EVENTS else use.kind
            for use in program.executors_of(node)
        }
        if not kinds:
            node.executor = (
                model.ExecutorKind.UNKNOWN if astray or node.escapes or node.runs_elsewhere else model.ExecutorKind.NONE
            )
        elif len(kinds) == 1:
            node.executor = kinds.pop()
        else:
            node.executor = (
                model.ExecutorKind.MULTI_THREADED
                if model.ExecutorKind.MULTI_THREADED in kinds
                else model.ExecutorKind.UNKNOWN
            )


def running(run: Run, node: model.Blueprint | None) -> model.ExecutorUse | None:
    """The executor that a node has been added to, where there is one."""
    uses = [use for use in run.program.executors if node is not None and node in use.nodes]
    return uses[0] if len(uses) == 1 else None


def _is_left_out(run: Run, spun: Sequence[model.Blueprint]) -> bool:
    """Whether a spin is in a thread that is never started."""
    if not run.context.never_starts:
        return False
    for node in spun:
        node.never_starting = run.context.registered or run.context.place
    return True


def _spins(run: Run, use: model.ExecutorUse, call: ApiUse, lasting: model.SpinDuration) -> None:
    if not use.spun or lasting > use.lasting:
        use.spun_at = _place(run, call)
    use.spun = True
    use.lasting = max(use.lasting, lasting)
    use.in_thread = use.in_thread or run.context.role == model.Role.THREAD


def _place(run: Run, call: ApiUse) -> Place:
    # A thread whose target is the spin itself: there is no call, but the place where it is passed.
    return run.context.place if call.expression is None else run.place(call.expression.span)


def _lasting(run: Run, call: ApiUse, spun: Sequence[model.Blueprint]) -> model.SpinDuration:
    """How long a spin goes on, by itself or because it is in a loop."""
    last = call.api.path.rpartition(".")[2]
    if last == "spin":
        return model.SpinDuration.TO_THE_END
    loops = [loop for activation in run.activations for loop in activation.loops]
    if last != "spin_once" or not loops or run.context.role not in _STARTED:
        return model.SpinDuration.A_MOMENT
    if any(_endless(loop) for loop in loops):
        return model.SpinDuration.TO_THE_END
    return model.SpinDuration.A_MOMENT if any(_makes(run, node) for node in spun) else model.SpinDuration.A_WHILE


@once_for
def _endless(loop: facts.While | facts.For) -> bool:
    """``while rclpy.ok()`` or ``while True``, with no other way out."""
    match loop:
        case facts.While(test):
            endless = test.truth is True or (isinstance(test, facts.Call) and called_name(test) == "ok")
            return endless and not loop_of(loop).is_left_by_jump
    return False


def _makes(run: Run, node: model.Blueprint) -> bool:
    """Whether the constructor of a node is running."""
    return any(
        activation.function is not None
        and activation.function.ir.name == "__init__"
        and nodes.known_node(run, activation.self_value) is node
        for activation in run.activations
    )


def spin(run: Run, call: ApiUse) -> Value:
    """``rclpy.spin(node)`` and its relatives."""
    spun = nodes.given_nodes(run, call.get("node"), plausible=False)
    lasting = _lasting(run, call, spun)
    if _is_left_out(run, spun):
        return Known(None)
    if run.context.role in _STARTED or spun != [run.context.node]:
        given = call.get("executor")
        use = use_of(run, given)
        if use is None:
            unknown = given is not None and not given.is_none
            use = _new_use(run, model.ExecutorKind.UNKNOWN, None, call) if unknown else _global_use(run)
        _spins(run, use, call, lasting)
        use.astray = use.astray or not spun
        _note_own_executor(spun if lasting == model.SpinDuration.TO_THE_END else ())
        for node in spun:
            _visit(use, node, replace(_spell(run, call, node, lasting), taken_from=_added_to(run, use, node)))
    _serve(run, call)
    if call.api.path == "rclpy.spin":
        made_nodes.end_imported(run)
    return Known(None)


def _spell(run: Run, call: ApiUse, node: model.Blueprint, lasting: model.SpinDuration) -> model.Spell:
    loop = next((activation.loops[-1] for activation in reversed(run.activations) if activation.loops), None)
    for_answer = (loop is not None and _asks_whether_done(loop)) or isinstance(call.get("future"), FutureValue)
    return model.Spell(_place(run, call), lasting, _makes(run, node), for_answer, len(node.creations))


@once_for
def _asks_whether_done(loop: facts.While | facts.For) -> bool:
    """``while not future.done()``."""
    match loop:
        case facts.While(test):
            return any(called_name(inner) == "done" for inner in calls_in(test))
    return False


def _added_to(run: Run, use: model.ExecutorUse, node: model.Blueprint) -> Place | None:
    """The other executor that a node has been added to for good."""
    others = (other for other in run.program.executors if other is not use and node in other.nodes)
    return next((other.place for other in others if node not in other.spells), None)


def _visit(use: model.ExecutorUse, node: model.Blueprint, spell: model.Spell) -> None:
    """A spin adds the node that it is given, and takes it off again."""
    if node not in use.nodes:
        use.spells[node] = []
        use.nodes.append(node)
    if node in use.spells and spell not in use.spells[node]:
        use.spells[node].append(spell)


def _note_own_executor(given: Sequence[model.Blueprint]) -> None:
    if len(given) == 1:
        given[0].has_own_executor = True


def _serve(run: Run, call: ApiUse) -> None:
    """A spin is where callbacks run: the pending ones in one without end, any in one that ends."""
    endless = call.api.path in ("rclpy.spin", "rclpy.executors.Executor.spin")
    if endless and run.context.role in (model.Role.MAIN, model.Role.MODULE) and run.at_spin is not None:
        run.at_spin(run)
    if not endless and run.after_moment is not None:
        run.after_moment(run)


def add_node(run: Run, call: ApiUse) -> Value:
    use = use_of(run, call.receiver)
    if use is not None:
        added = nodes.given_nodes(run, call.get("node"), plausible=False)
        use.astray = use.astray or not added
        _note_own_executor(added)
        for node in added:
            _put(run, use, node)
    return Known(True)


def remove_node(run: Run, call: ApiUse) -> Value:
    """``executor.remove_node(node)``, where nothing can have spun the executor by then: later it is clearing up."""
    use = use_of(run, call.receiver)
    removed = nodes.given_nodes(run, call.get("node"), plausible=False)
    at_start = run.context.role in (model.Role.MAIN, model.Role.MODULE) and not run.branch_arms
    concurrent = any(callback.role in (model.Role.THREAD, model.Role.METHOD) for callback in run.program.callbacks)
    repeated = any(activation.loops or activation.tries for activation in run.activations)
    if use is None or use.spun or not at_start or concurrent or repeated:
        return Known(None)
    for node in removed if len(removed) == 1 else ():
        if node in use.nodes:
            use.nodes.remove(node)
            use.spells.pop(node, None)
            node.removed_at = _place(run, call)
    return Known(None)


def set_executor(run: Run, target: Value, value: Value) -> None:
    """``node.executor = executor`` adds the node to the executor."""
    use, node = use_of(run, value), nodes.known_node(run, target)
    if use is not None and node is not None:
        _put(run, use, node)


def executor_spin(run: Run, call: ApiUse) -> Value:
    use = use_of(run, call.receiver)
    if use is not None and not _is_left_out(run, use.nodes):
        _spins(run, use, call, _lasting(run, call, use.nodes))
    _serve(run, call)
    return Known(None)
