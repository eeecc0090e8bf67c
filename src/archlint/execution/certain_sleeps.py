"""How long a callback sleeps each time it runs, for certain."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.analysis.source_code import source_code
from archlint.execution.polling import is_unguarded
from archlint.execution.sleeps import SLEEP, longest

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


def certain_sleep(system: System, call: ApiCall) -> float:
    """The seconds that a call sleeps each time, where nothing decides whether it is reached; of any other call none."""
    value = argument(call, "seconds")
    if call.api != SLEEP or value is None or len(value.alternatives) != 1 or call.conditional or call.looped:
        return 0.0
    return longest(value) or 0.0 if is_unguarded(source_code(system), call) else 0.0


__all__ = ["certain_sleep"]
