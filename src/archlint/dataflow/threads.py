"""Which callbacks wait for each other: one thread runs them, or one callback group lets one of them run at a time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.dataflow.model import StepKind
from archlint.execution import blocking
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import group_relation, threads_of

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step


def waits_for(flow: Flow, step: Step) -> Iterator[Step]:
    """The other callbacks that a callback waits for while they run, as far as the source shows it."""
    callback, program = step.callback, step.program
    if callback is None or program is None or not runs_in_executor(callback):
        return
    for other in _by_program(flow).get(id(program), ()):
        if other is not step and _wait_for_each_other(step, other):
            yield other


@once
def _by_program(flow: Flow) -> Mapping[int, Sequence[Step]]:
    """The callbacks that executors run, by their programs (``id``)."""
    steps: dict[int, list[Step]] = {}
    for step in flow.steps:
        if step.kind == StepKind.CALLBACK and step.callback is not None and runs_in_executor(step.callback):
            steps.setdefault(id(step.program), []).append(step)
    return steps


def _wait_for_each_other(step: Step, other: Step) -> bool:
    callback, second, program = step.callback, other.callback, step.program
    assert callback is not None and second is not None and program is not None
    if callback.node is None or second.node is None:
        return False
    shared = [use for use in program.executors_of(callback.node) if use in program.executors_of(second.node)]
    if not shared:
        return False
    if threads_of(callback.node, program) == blocking.ONE:
        return True
    same_node = callback.node is second.node
    groups = callback.group, second.group
    if None in groups:
        return False
    return (same_node or groups[0] == groups[1]) and group_relation(*groups) == blocking.SAME


__all__ = ["waits_for"]
