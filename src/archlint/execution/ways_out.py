"""Processes on the way out of a program: every way on from there ends the program or its node."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.analysis.order import paths_to
from archlint.execution.loop_times import in_loops
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import without_exceptions
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.finding import Place
    from archlint.model import ApiCall


OF_PROCESS = ("subprocess.Popen.wait", "subprocess.Popen.communicate")
_ENDS_OF_ROS = frozenset({"rclpy.shutdown", "rclpy.try_shutdown"})
_SHUTDOWNS = _ENDS_OF_ROS | {"self.destroy_node"}
_ENDS_OF_PROGRAM = frozenset({"sys.exit", "os._exit", "exit", "quit"})


def ends_with_the_node(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a limited wait for a process is part of the way out: every way on shuts ROS down or destroys the node,
    and nothing that would have to wait ever comes."""
    return call.api in OF_PROCESS and stay.seconds is not None and not call.looped and _ends_in(code, call, _SHUTDOWNS)


def hands_over(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether every way on from a wait ends the program: a process was started in its place or as the last step, or
    there is a pause before the end."""
    is_last = stay.kind == "process" or (stay.kind == "sleep" and not call.looped)
    return is_last and _ends_in(code, call, _ENDS_OF_PROGRAM)


def says_farewell(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a pause, or a loop with pauses, for a second at most, is what a callback does last before it ends ROS or
    the program: it stops the robot by several commands, and nobody waits for another callback any more."""
    if stay.kind != "sleep" or in_loops(code, call, stay, with_callers=True) > _FAREWELL:
        return False
    return _ends_in(code, call, _ENDS_OF_ROS) or _ends_in(code, call, _ENDS_OF_PROGRAM)


_FAREWELL = 1.0
"""Seconds."""


def ends_at_a_miss(code: SourceCode, call: ApiCall) -> bool:
    """Whether a wait that is in vain ends ROS or the program, so that it is in vain once: ``if not
    client.wait_for_server(timeout_sec=3.0): self.give_up()``, with ``rclpy.shutdown()`` in that method."""
    file_facts, lines = code.facts_at(call.file), lines_of_miss(code, call)
    if file_facts is None or not lines:
        return False
    own = {inner.func.attribute for inner in calls_in(lines) if inner.func.dotted.startswith("self.")}
    methods = [each for each in everything_in(file_facts.body, facts.Function) if each.name in own]
    ends = _ENDS_OF_ROS | _ENDS_OF_PROGRAM
    return any(
        inner.func.dotted in ends for body in (lines, *(each.body for each in methods)) for inner in calls_in(body)
    )


def lines_of_miss(code: SourceCode, call: ApiCall) -> list[facts.Stmt]:
    """What a function does where a call returns false: the body of ``if not ….wait_for_service(timeout_sec=1.0):``."""
    return [
        line
        for branch in statements_of(code.body(call), facts.If)
        if isinstance(branch.test, facts.Unary)
        and isinstance(branch.test.negated, facts.Call)
        and branch.test.negated.span == call.place.span
        for line in branch.body
    ]


def _ends_in(code: SourceCode, call: ApiCall, functions: AbstractSet[str]) -> bool:
    """Whether every way on from a call leads to a call of one of some functions, in the function that holds it or in
    one that has called that."""
    return all(any(_leads_to(code, place, functions) for place in path) for path in paths_to(call))


def _leads_to(code: SourceCode, place: Place, functions: AbstractSet[str]) -> bool:
    graph = graph_of(code.body_at(place))
    waits = graph.evaluating(place.span)
    ends = [block for block in graph.blocks if _is_end(block.fact, functions)]
    return bool(waits) and all(graph.post_dominates(ends, block, without_exceptions) for block in waits)


def _is_end(fact: facts.Base | None, functions: AbstractSet[str]) -> bool:
    """Whether a line calls one of some functions, or raises what ends the program (where that is asked for)."""
    if isinstance(fact, facts.Raise) and functions is _ENDS_OF_PROGRAM:
        return any(part.id == "SystemExit" for part in everything_in([fact], facts.Name))
    return any(inner_call.func.dotted in functions for inner_call in calls_in(fact))


__all__ = ["OF_PROCESS", "ends_at_a_miss", "ends_with_the_node", "hands_over", "lines_of_miss", "says_farewell"]
