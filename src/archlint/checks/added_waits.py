"""EXE003: waits of a timer's callback that are short each, and too long together."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.execution.added_limits import AddedLimits, added_limits
from archlint.execution.callback_roles import callback_words
from archlint.execution.kept_waiting import Waiting, who_waits
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.systems.model import System


def added_waits(system: System, told: Collection[int]) -> Iterator[Finding]:
    """One finding for a callback, at its first wait; none for those of ``told``, by ``id()``: there a wait is too long
    by itself."""
    for row in added_limits(system):
        if id(row.waits[0][0].context) not in told:
            yield _finding(system, row)


def _finding(system: System, row: AddedLimits) -> Finding:
    (call, _), *others = row.waits
    late = "its next turn is late"
    waiting = {who_waits(source_code(system), wait, row.program) for wait, _ in row.waits}
    if Waiting.OTHERS in waiting:
        late += ", and so is every other callback on its thread"
    diagnostic = finding_in_callback(
        "EXE003",
        system,
        row.program,
        call,
        f"{callback_words(call.context)} waits for up to {row.seconds:.3g} s in {len(row.waits)} calls one after the "
        f"other, longer than its period of {row.period:g} s: {late}",
        help="check once without waiting, and try again in the next turn",
        further=(Related(wait.place, f"then it {stay.words}", again=True) for wait, stay in others),
        identity=("added", call.api),
    )
    return diagnostic if Waiting.OTHERS in waiting else replace(diagnostic, severity=Severity.INFO)


__all__ = ["added_waits"]
