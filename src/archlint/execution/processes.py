"""Processes that a program has started, has just asked to end, and then waits for."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.execution.ways_out import OF_PROCESS
from archlint.python_code.assumptions import dotted
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Edge, Kind
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_ENDS = frozenset({"terminate", "kill", "send_signal"})
_ENDING: frozenset[object] = frozenset({"SIGKILL", 9, "SIGINT", 2, "SIGTERM", 15, "SIGHUP", 1, "SIGQUIT", 3})
"""Signals that end a process: always, or unless it does otherwise."""


def is_signalled_to_end(code: SourceCode, call: ApiCall) -> bool:
    """Whether a process that is waited for was just asked to end: ``process.terminate(); process.wait(timeout=1)``.
    Hardly any takes that for a hint only, so that a limit makes no difference."""
    expression = code.expression(call)
    name = "" if expression is None or call.api not in OF_PROCESS else _owner(expression)
    if not name:
        return False
    graph = graph_of(code.body(call))
    earlier = graph.before(graph.evaluating(call.place.span), _in_this_iteration)
    groups = _numbers_of(code.body(call), name)
    return any(
        (earlier_call.func.attribute in _ENDS and _owner(earlier_call) == name) or _signals(earlier_call, name, groups)
        for block in earlier
        for earlier_call in calls_in(block.fact)
    )


def _in_this_iteration(edge: Edge) -> bool:
    return edge.kind is not Kind.BACK


def _numbers_of(body: Sequence[facts.Stmt], process: str) -> frozenset[str]:
    """The variables that hold the number of a process or of its group: ``pgid = os.getpgid(process.pid)``."""
    assigned: dict[str, bool] = {}
    for statement in everything_in(body, facts.Assign):
        for target in filter(None, (target.variable for target in statement.targets)):
            assigned[target] = assigned.get(target, True) and _is_number_of(statement.value, process)
    return frozenset(variable for variable, always in assigned.items() if always)


def _is_number_of(value: facts.Expr, process: str) -> bool:
    """Whether a value comes from ``process.pid``."""
    return any(part.attr == "pid" and dotted(part.value) == process for part in everything_in([value], facts.Attribute))


def _signals(call: facts.Call, process: str, numbers: AbstractSet[str]) -> bool:
    """Whether a call is ``os.kill(process.pid, signal.SIGTERM)``, or the same for the process's group.  What the number
    of a signal is, a variable does not say: with one, the process is asked to end, though not for certain."""
    if dotted(call.func) not in ("os.kill", "os.killpg") or len(call.args) != len(("pid", "sig")):
        return False
    who, what = (argument.value for argument in call.args)
    number = what.value if isinstance(what, facts.Literal) else dotted(what).rpartition(".")[2]
    ends = number in _ENDING or bool(what.variable)
    return ends and (who.variable in numbers or _is_number_of(who, process))


def _owner(call: facts.Call) -> str:
    """``self.process`` of ``self.process.wait()``; empty where it is no variable, and no attribute of one."""
    return dotted(call.func.value) if isinstance(call.func, facts.Attribute) else ""


__all__ = ["is_signalled_to_end"]
