"""Callbacks that show what happens while one is busy, and do nothing else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import Callback

_TELLS = frozenset({"debug", "error", "fatal", "get_logger", "info", "log", "print", "warn", "warning"}) | {
    *("format", "len", "range", "str", "type", "get_name", "current_thread", "get_ident"),
    *("get_clock", "monotonic", "now", "perf_counter", "time"),
}
"""What only says something, or is there to say what."""
_SLEEP = "sleep"


def stands_for_work(code: SourceCode, callback: Callback) -> bool:
    """Whether a callback does nothing but sleep and say so, and what a handler answers comes of its request: the sleep
    stands for work, and who wrote it wants to see what waits meanwhile."""
    function = code.definition(callback)
    if function is None or any(True for _ in statements_of(function.body, facts.With)):
        return False
    names = {called_name(call) for call in calls_in(function.body)}
    kept = (target for line in statements_of(function.body, facts.Assign) for target in line.targets)
    changes_nothing = all(not (target.dotted or "").startswith("self.") for target in kept)
    return _SLEEP in names and names <= _TELLS | {_SLEEP} and changes_nothing


__all__ = ["stands_for_work"]
