"""Waits for processes that a program has started."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.assumptions import dotted
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.analysis.sleeps import Stay
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_OF_PROCESS = ("subprocess.Popen.wait", "subprocess.Popen.communicate")
_ENDS = frozenset({"terminate", "kill", "send_signal"})
_KILLS = frozenset({"kill"})


def is_told_to_end(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a process that is waited for has just been told to end: ``process.terminate(); process.wait(timeout=1)``.
    Without a limit it has to be killed: only that cannot be ignored."""
    expression = code.expression(call)
    name = "" if expression is None or call.api not in _OF_PROCESS else _owner(expression)
    ends = _KILLS if stay.seconds is None else _ENDS
    return name != "" and any(
        one.func.attribute in ends and _owner(one) == name and Place.of(call.file, one.span) < call.place
        for one in calls_in(code.body(call))
    )


def _owner(call: facts.Call) -> str:
    """``self.process`` of ``self.process.wait()``; empty where it is no variable, and no attribute of one."""
    return dotted(call.func.value) if isinstance(call.func, facts.Attribute) else ""


__all__ = ["is_told_to_end"]
