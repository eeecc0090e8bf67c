"""EXE003: waits of a callback that are too brief to be worth a word."""

from __future__ import annotations

import math
import posixpath
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.wait_words import made_here
from archlint.execution.device_pauses import is_for_an_answer, is_for_what_has_not_arrived
from archlint.execution.long_stays import LongStay, period_of
from archlint.execution.loop_times import in_loops
from archlint.execution.short_stays import is_soon_over
from archlint.execution.states import leaves_its_state
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.execution.sleeps import Stay
    from archlint.model import ApiCall
    from archlint.systems.model import System


def are_brief(system: System, rows: Sequence[LongStay], *, quiet: bool) -> bool:
    """Whether the waits of a function are sleeps in a trial, or ``quiet`` and short looks for servers, commands that
    the response to a request tells of, or pauses that are made on purpose."""
    code = source_code(system)
    if all(_is_in_a_test(code, row) for row in rows):
        return True
    return quiet and (
        _looks_briefly(system, rows)
        or _runs_commands_for_a_request(rows)
        or _are_on_purpose(system, code, rows)
        or _come_once(code, rows)
        or all(stay.kind == "sleep" and is_soon_over(system, program, call) for program, call, stay in rows)
    )


_BRIEF = 0.2
"""Seconds of sleep that say nothing in a program which somebody watches while it tries something out."""
_OF_A_TEST = re.compile(r"(?:^|[\W_\d])[Tt]ests?(?![a-z])|[a-z]Tests?(?![a-z])")
"""How a word of a file's name says that it is a test, in snake case or in camel case."""


def _is_in_a_test(code: SourceCode, row: LongStay) -> bool:
    _, call, stay = row
    brief = (
        stay.kind == "sleep" and stay.seconds is not None and in_loops(code, call, stay, with_callers=True) <= _BRIEF
    )
    return brief and _OF_A_TEST.search(posixpath.basename(call.file)) is not None


_LOOK = 2.0
"""Seconds for which a callback may look for servers that are there as a rule."""


def _looks_briefly(system: System, rows: Sequence[LongStay]) -> bool:
    """Whether a function only looks for servers, for a short time in all, and seldom: it returns at once where they are
    there, and a timer that does so without a break would keep the thread for as long as they are not."""
    return sum(stay.seconds or math.inf for _, _, stay in rows) <= _LOOK and all(
        stay.kind == "discovery"
        and not call.looped
        and not made_here(call)
        and not _fills_its_period(system, call, stay)
        for _, call, stay in rows
    )


def _fills_its_period(system: System, call: ApiCall, stay: Stay) -> bool:
    period = period_of(system, call)
    return period is not None and (stay.seconds or math.inf) >= period


_COMMANDS = 10.0
"""Seconds that the commands of a request may take at most: few need a part of that."""


def _runs_commands_for_a_request(rows: Sequence[LongStay]) -> bool:
    """Whether a service handler only runs commands, which it ends itself after a short time in all: the client wants
    to know how they went."""
    return sum(stay.seconds or math.inf for _, _, stay in rows) <= _COMMANDS and all(
        stay.kind == "process" and call.context.role == Role.SERVICE and not call.looped for _, call, stay in rows
    )


_PAUSES = 1.0
"""Seconds of pauses that a device or a lack of data explains."""


def _are_on_purpose(system: System, code: SourceCode, rows: Sequence[LongStay]) -> bool:
    """Whether a function only pauses, for a short time in all: around what it asks a device, or where a timer's
    callback has nothing to do yet and returns."""
    sleeps = all(stay.kind == "sleep" and not call.looped for _, call, stay in rows)
    if not sleeps or sum(stay.seconds or math.inf for _, _, stay in rows) > _PAUSES:
        return False
    if any(is_for_an_answer(code, call) and not _fills_its_period(system, call, stay) for _, call, stay in rows):
        return len({call.function for _, call, _ in rows}) == 1
    return all(call.context.role == Role.TIMER and is_for_what_has_not_arrived(code, call) for _, call, _ in rows)


_ONCE = 2.0
"""Seconds that a node may lose once, on its way from one state to the next."""


def _come_once(code: SourceCode, rows: Sequence[LongStay]) -> bool:
    """Whether a function only sleeps, for a short time in all, and in a state of its node that it leaves there."""
    seconds = sum(in_loops(code, call, stay, with_callers=True) for _, call, stay in rows)
    return seconds <= _ONCE and all(stay.kind == "sleep" and leaves_its_state(code, call) for _, call, stay in rows)


__all__ = ["are_brief"]
