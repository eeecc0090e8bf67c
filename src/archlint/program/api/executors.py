"""Executors: which one spins which node, and with how many threads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.program import model
from archlint.program.api import nodes
from archlint.program.values import ExecutorValue, Instance, Known, OneOf, Unknown, Value

if TYPE_CHECKING:
    from archlint.program.api.effects import ApiUse
    from archlint.program.api.tables import Api
    from archlint.program.run import Run


def make_executor(run: Run, call: ApiUse) -> Value:
    use = _new_use(run, call.api.kind, call.get("num_threads"), call)
    return ExecutorValue(use, call.api.path, run.store.new_key())


def adopt_executor(run: Run, api: Api, receiver: Instance, args: list[Value], keywords: dict[str, Value]) -> Value:
    """An executor class of ours: ``super().__init__()`` tells which kind it is."""
    threads = keywords.get("num_threads", args[0] if args else None)
    run.store.set(receiver.key, "#executor", _new_use(run, api.kind, threads, None))
    return Known(None)


def _new_use(run: Run, kind: str, threads: Value | None, call: ApiUse | None) -> model.ExecutorUse:
    count = threads.value if isinstance(threads, Known) and isinstance(threads.value, int) else None
    if kind in ("single_threaded", "events"):
        count = 1
    place = run.place(call.expression.span) if call is not None and call.expression is not None else None
    use = model.ExecutorUse(kind, count, [], place)
    run.program.executors.append(use)
    return use


def use_of(run: Run, value: Value | None) -> model.ExecutorUse | None:
    if isinstance(value, ExecutorValue):
        return value.use
    if isinstance(value, Instance):
        use = run.store.get(value.key, "#executor")
        return use if isinstance(use, model.ExecutorUse) else None
    if isinstance(value, OneOf):
        found = [use for use in (use_of(run, option) for option in value.values) if use is not None]
        return found[0] if len(found) == 1 else None
    return None


def _global_use(run: Run) -> model.ExecutorUse:
    """The process-wide single-threaded executor of ``rclpy.spin``."""
    for use in run.program.executors:
        if use.place is None and use.kind == "single_threaded":
            return use
    use = model.ExecutorUse("single_threaded", 1, [], None)
    run.program.executors.append(use)
    return use


def _put(use: model.ExecutorUse, node: model.Blueprint) -> None:
    if node not in use.nodes:
        use.nodes.append(node)


def settle(program: model.Program) -> None:
    """Say of each node which kind of executor serves it, once all of them are known."""
    astray = any(use.kind == "unknown" and use.spun and not use.nodes for use in program.executors)
    for node in program.nodes:
        uses = [use for use in program.executors if use.spun and node in use.nodes]
        # What spins until a future is done is only a helper before the real one.
        uses = [use for use in uses if use.steady] or uses
        kinds = {"single_threaded" if use.kind == "events" else use.kind for use in uses}
        if not kinds:
            node.executor = "unknown" if astray or node.handed_out else "none"
        elif len(kinds) == 1:
            node.executor = kinds.pop()
        else:
            node.executor = "multi_threaded" if "multi_threaded" in kinds else "unknown"


def running(run: Run, node: model.Blueprint | None) -> model.ExecutorUse | None:
    """The executor that a node has been added to, where there is one."""
    found = [use for use in run.program.executors if node is not None and node in use.nodes]
    return found[0] if len(found) == 1 else None


def _spins(run: Run, use: model.ExecutorUse, call: ApiUse) -> None:
    use.spun = True
    last = call.api.path.rpartition(".")[2]
    use.steady = use.steady or last == "spin" or (last == "spin_once" and bool(run.rounds()))
    use.in_thread = use.in_thread or run.context.role == "thread"
    if use.spun_at is None:
        # A thread whose target is the spin itself: there is no call, but the place where it is handed over.
        use.spun_at = run.context.place if call.expression is None else run.place(call.expression.span)


def spin(run: Run, call: ApiUse) -> Value:
    """``rclpy.spin(node)`` and its relatives."""
    given = call.get("executor")
    use = use_of(run, given)
    if use is None:
        unknown = given is not None and not (isinstance(given, Known) and given.value is None)
        use = _new_use(run, "unknown", None, call) if unknown else _global_use(run)
    _spins(run, use, call)
    if run.context.role in ("init", "main", "module", "thread", "method"):
        for node in nodes.nodes_of(run, call.get("node"), plausible=False):
            _put(use, node)
    _serve(run, call)
    return Unknown("what a spin gives")


def _serve(run: Run, call: ApiUse) -> None:
    """A spin without end is where callbacks run."""
    endless = call.api.path in ("rclpy.spin", "rclpy.executors.Executor.spin")
    if endless and run.context.role in ("main", "module") and run.at_spin is not None:
        run.at_spin(run)


def add_node(run: Run, call: ApiUse) -> Value:
    use = use_of(run, call.receiver)
    if use is not None:
        for node in nodes.nodes_of(run, call.get("node"), plausible=False):
            _put(use, node)
    return Known(True)


def executor_spin(run: Run, call: ApiUse) -> Value:
    use = use_of(run, call.receiver)
    if use is not None:
        _spins(run, use, call)
    _serve(run, call)
    return Unknown("what a spin gives")
