"""Spins of a thread for a node that the program spins already, on its own thread or on one that it starts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.execution.blocking import ANY, ONE, OTHER, SPIN, STEAL, Outcome, look_up
from archlint.execution.spins import is_spin_call, spun_node
from archlint.model import Role, SpinDuration
from archlint.model.given import Constant
from archlint.records import dataclass
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.execution.blocking import Verdict
    from archlint.finding import Place
    from archlint.model import ApiCall, Program


@dataclass(frozen=True)
class SpunBeside:
    """Where the program spins the node to the end, and what a second spin of it comes to."""

    place: Place | None
    verdict: Verdict


def spun_beside(code: SourceCode, call: ApiCall, program: Program, distros: Sequence[str]) -> SpunBeside | None:
    """What becomes of ``rclpy.spin_until_future_complete(node, …)`` in a thread while the program spins the node, or
    anywhere while a thread does; None where nothing is seen to go wrong.

    Tried with rclpy 7.1.5 and 9.1.2: on the global executor it works, and one of the node's own loses the node.  Later
    releases refuse the first, as they do in a callback (:data:`archlint.execution.blocking.NESTED_SINCE`).
    """
    node = spun_node(call, program)
    given = argument(call, "executor")
    if node is None or not call.api.startswith("rclpy.spin") or not (given is None or given == Constant(None)):
        return None
    for use in program.executors:
        if node not in use.nodes or use.lasts_for(node) != SpinDuration.TO_THE_END:
            continue
        place = use.spins_at(node)
        spin = next((other for other in program.calls if other.place == place and is_spin_call(other)), None)
        if spin is not None and spin.context.role in (Role.MAIN, Role.MODULE):
            beside = call.context.role == Role.THREAD and not _waits_for_thread_before(code, spin)
        else:
            beside = use.in_thread and call.context.role in (Role.THREAD, Role.METHOD) and not _is_of(call, spin)
        if not beside:
            continue
        if use.place is None:
            verdict = look_up(SPIN, ONE, OTHER, "another thread spins this node already", distros)
        else:
            verdict = look_up(STEAL, ANY, OTHER, "another thread spins this node on its own executor", distros)
        return None if set(verdict.outcomes.values()) == {Outcome.FINE} else SpunBeside(place, verdict)
    return None


def _is_of(call: ApiCall, spin: ApiCall | None) -> bool:
    """Whether one thread comes to both spins; a thread whose target is the spin itself makes no call."""
    return spin is not None and call.context.place == spin.context.place


def _waits_for_thread_before(code: SourceCode, spin: ApiCall) -> bool:
    """Whether the function that spins has a ``thread.join()`` further up."""
    before = (each for each in calls_in(code.body(spin)) if each.span < spin.place.span)
    return any(called_name(each) == "join" and all(given.keyword for given in each.args) for each in before)


__all__ = ["SpunBeside", "spun_beside"]
