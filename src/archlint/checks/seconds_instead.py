"""What to write where a call is given a Duration and takes a number of seconds under another name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.libraries.api_signatures import signatures_of
from archlint.model import Misuse, RefusedCall
from archlint.python_code.numbers_for_times import duration_given

if TYPE_CHECKING:
    from archlint.systems.model import System

_TAKEN, _MEANT = "timeout", "timeout_sec"


def cure_of_duration(system: System, call: RefusedCall) -> str:
    """What to write for ``wait_for_service(timeout=Duration(seconds=10))``; empty for other mistakes."""
    if call.misuse is not Misuse.UNKNOWN_KEYWORD or call.parameters != (_TAKEN,):
        return ""
    rows = signatures_of(call.api).values()
    given = duration_given(system, call.place, _TAKEN)
    if given is None or not any(_MEANT in (*row.positional, *row.by_name) for row in rows):
        return ""
    duration, seconds = given
    return f"write {_MEANT}={seconds or '…'} instead of {_TAKEN}={duration}(…): it takes a number of seconds"


__all__ = ["cure_of_duration"]
