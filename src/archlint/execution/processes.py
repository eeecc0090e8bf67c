"""Waits for processes that a program has started."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.python_code.assumptions import dotted
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Edge, Kind, without_exceptions
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.model import ApiCall

_OF_PROCESS = ("subprocess.Popen.wait", "subprocess.Popen.communicate")
_ENDS = frozenset({"terminate", "kill", "send_signal"})
_KILLS = frozenset({"kill"})
_SHUTDOWNS = frozenset({"rclpy.shutdown", "rclpy.try_shutdown", "self.destroy_node"})
_ENDS_OF_PROGRAM = frozenset({"sys.exit", "os._exit", "exit", "quit"})
_KILLING: frozenset[object] = frozenset({"SIGKILL", 9})
_ENDING = _KILLING | {"SIGINT", 2, "SIGTERM", 15, "SIGHUP", 1, "SIGQUIT", 3}
"""Signals that end a process: always, or unless it does otherwise."""


def is_signalled_to_end(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a process that is waited for was just asked to end: ``process.terminate(); process.wait(timeout=1)``.
    Without a limit it has to be killed: only that cannot be ignored."""
    expression = code.expression(call)
    name = "" if expression is None or call.api not in _OF_PROCESS else _owner(expression)
    ends = _KILLS if stay.seconds is None else _ENDS
    if not name:
        return False
    graph = graph_of(code.body(call))
    earlier = graph.before(graph.evaluating(call.place.span), _in_this_iteration)
    groups = _numbers_of(code.body(call), name)
    return any(
        (earlier_call.func.attribute in ends and _owner(earlier_call) == name)
        or _signals(earlier_call, name, groups, stay.seconds is None)
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


def _signals(call: facts.Call, process: str, numbers: AbstractSet[str], certainly: bool) -> bool:
    """Whether a call is ``os.kill(process.pid, signal.SIGTERM)``, or the same for the process's group.  What the number
    of a signal is, a variable does not say: with one, the process is asked to end, though not for certain."""
    if dotted(call.func) not in ("os.kill", "os.killpg") or len(call.args) != len(("pid", "sig")):
        return False
    who, what = (argument.value for argument in call.args)
    number = what.value if isinstance(what, facts.Literal) else dotted(what).rpartition(".")[2]
    ends = number in (_KILLING if certainly else _ENDING) or (bool(what.variable) and not certainly)
    return ends and (who.variable in numbers or _is_number_of(who, process))


def ends_with_the_node(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a limited wait for a process is part of the way out: every way on shuts ROS down or destroys the node,
    and nothing that would have to wait ever comes."""
    return call.api in _OF_PROCESS and stay.seconds is not None and not call.looped and _ends_in(code, call, _SHUTDOWNS)


_SWITCHES_OFF = frozenset({"shutdown", "poweroff", "reboot", "halt"})
_IN_FRONT = frozenset({"sudo", "systemctl"})


def hands_over(code: SourceCode, call: ApiCall) -> bool:
    """Whether every way on from a process ends the program: it was started in its place, or as the last step."""
    return _ends_in(code, call, _ENDS_OF_PROGRAM)


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


def ends_the_machine(code: SourceCode, call: ApiCall) -> bool:
    """Whether a command switches the machine off, or starts it anew: nothing that would have to wait goes on."""
    words = _words(code, call)
    commands = [word.rpartition("/")[2] for word in words if not word.startswith("-")]
    command = next((word for word in commands if word not in _IN_FRONT), "")
    return command in _SWITCHES_OFF and "-c" not in words  # `shutdown -c` calls it off


def is_soon_over(code: SourceCode, call: ApiCall) -> bool:
    """Whether a command only sets something, or asks the state of something, on this machine: milliseconds."""
    return all(map(_asks_for_a_moment, _commands(code, call)))


def _asks_for_a_moment(command_line: Sequence[str]) -> bool:
    words = [word.rpartition("/")[2] for word in command_line if not word.startswith("-")]
    match words:
        case ["systemctl", "is-active" | "is-enabled" | "is-failed", *_]:
            return True
        case ["ip", *rest]:
            return _LASTING.isdisjoint(rest)
        case ["nmcli", *rest]:
            return bool({"show", "status"} & set(rest)) and _LASTING.isdisjoint(rest)
        case [command, *_]:
            return command in _SHORT
    return False


_SHORT = frozenset(
    {
        "amixer",
        "i2cdetect",
        "i2cget",
        "i2cset",
        "lsblk",
        "lspci",
        "lsusb",
        "pactl",
        "wpctl",
        "hostname",
        "ifconfig",
        "iw",
        "iwconfig",
        "iwgetid",
        "uname",
        "vcgencmd",
    }
    | {"kill", "killall", "pgrep", "pidof", "pkill"}
)
"""Commands that ask the kernel or a service of this machine for something, or set it, and end."""
_LASTING = frozenset({"event", "exec", "monitor", "rescan", "scan"})
"""Words that make such a command last."""


def _words(code: SourceCode, call: ApiCall) -> list[str]:
    """The words of a command that are written out."""
    return _words_in([argument.value for argument in code.arguments(call)[:1]])


def _commands(code: SourceCode, call: ApiCall) -> list[list[str]]:
    """The words of each command that a call may start: of several that a ``for`` goes through, all of them."""
    variable = next((argument.value.variable for argument in code.arguments(call)[:1]), "")
    for loop in code.loops(call):
        if variable and isinstance(loop, facts.For) and loop.target.variable == variable:
            rows = loop.iterable.elements if isinstance(loop.iterable, facts.Sequence) else []
            return [_words_in([row]) for row in rows] or [[]]
    return [_words(code, call)]


def _words_in(values: Sequence[facts.Base]) -> list[str]:
    literals = everything_in(values, facts.Literal)
    return [word for literal in literals if isinstance(literal.value, str) for word in literal.value.split()]


def _owner(call: facts.Call) -> str:
    """``self.process`` of ``self.process.wait()``; empty where it is no variable, and no attribute of one."""
    return dotted(call.func.value) if isinstance(call.func, facts.Attribute) else ""


__all__ = ["ends_the_machine", "ends_with_the_node", "hands_over", "is_signalled_to_end", "is_soon_over"]
