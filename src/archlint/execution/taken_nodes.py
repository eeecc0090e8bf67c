"""Nodes that a short spin takes from the executor which is to run them, so that it has them no more.

Source: ``Executor.add_node`` of rclpy sets ``node.executor``, which takes the node from the one that had it, and
``rclpy.spin_once()`` and ``rclpy.spin_until_future_complete()`` add the node to the global executor for as long as they
spin, and then remove it.  Tried with rclpy of jazzy: no timer of the node runs afterwards.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.model import Role, SpinDuration
from archlint.records import dataclass
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import reach

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall, Blueprint, ExecutorUse, Program
    from archlint.place import Place


@dataclass(frozen=True)
class Taken:
    """The ``call`` that takes a node, and where the executor is made that had it."""

    call: Place
    api: str
    executor: Place


def taken(code: SourceCode, program: Program, node: Blueprint) -> Taken | None:
    """What takes a node from its executor for good; None where nothing certainly does."""
    spells = [spell for use in program.executors for spell in use.spells.get(node, ())]
    if any(spell.lasting is SpinDuration.TO_THE_END for spell in spells):
        return None
    for spell in spells:
        executor = next((use for use in program.executors if use.place == spell.taken_from), None)
        call = next((call for call in program.calls if call.place == spell.place), None)
        if spell.taken_from is None or executor is None or call is None or spell.in_constructor:
            continue
        if executor.lasting is SpinDuration.TO_THE_END and _is_spun_by_then(code, executor, call):
            return Taken(call.place, call.api, spell.taken_from)
    return None


def _is_spun_by_then(code: SourceCode, executor: ExecutorUse, call: ApiCall) -> bool:
    """Whether an executor spins when a call has been made, or afterwards, where the program makes it but once."""
    if call.context.role not in (Role.MAIN, Role.MODULE) or call.looped or call.branch_arms:
        return False
    if executor.in_thread or executor.spun_at is None:
        return executor.in_thread
    places = (call.place, *(frame.place for frame in call.chain))
    graph = graph_of(code.body_at(executor.spun_at))
    spins = graph.evaluating(executor.spun_at.span)
    within = [place for place in places if place.file == executor.spun_at.file]
    calls = [block for place in within for block in graph.evaluating(place.span) if block not in spins]
    return not reach(calls).isdisjoint(spins)


__all__ = ["Taken", "taken"]
