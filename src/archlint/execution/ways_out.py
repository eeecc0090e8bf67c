"""Processes on the way out of a program: every way on from there ends the program or its node."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import without_exceptions
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.model import ApiCall


OF_PROCESS = ("subprocess.Popen.wait", "subprocess.Popen.communicate")
_SHUTDOWNS = frozenset({"rclpy.shutdown", "rclpy.try_shutdown", "self.destroy_node"})
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


def _ends_in(code: SourceCode, call: ApiCall, functions: AbstractSet[str]) -> bool:
    """Whether every way on from a call leads to a call of one of some functions."""
    graph = graph_of(code.body(call))
    waits = graph.evaluating(call.place.span)
    ends = [
        block
        for block in graph.blocks
        if any(inner_call.func.dotted in functions for inner_call in calls_in(block.fact))
    ]
    return bool(waits) and all(graph.post_dominates(ends, block, without_exceptions) for block in waits)


__all__ = ["OF_PROCESS", "ends_with_the_node", "hands_over"]
