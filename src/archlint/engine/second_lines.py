"""Findings about lines to which no run comes: another finding says that a line before them fails, or the call itself,
or they stand behind a spin that Ctrl-C ends with an exception."""

from __future__ import annotations

from collections.abc import Iterable, Set
from typing import TYPE_CHECKING

from archlint.analysis.behind_failures import BehindFailures
from archlint.checks.undefined_names import PAST_HANDLER
from archlint.python_code.behind_spins import is_behind_a_spin

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.systems.model import WorkspaceIndex

_AT_THE_END = frozenset({"EXE015", "EXE016", "EXE017"})
"""Rules that tell how a program ends."""
_OF_LINES = frozenset({"API001", "API002", "API005", "MSG001", "MSG003"})
"""Rules that tell which line raises an exception, or sends something else.  Two such lines of one function are two
mistakes, whichever of them is reached; but for one that fails only where an ``except`` has run that no run comes to."""
_OF_CALLS = ("EXE", "TMO")
"""Families of rules that tell what a call waits for or keeps waiting: one that raises an exception at once does not."""
_BEHIND_SPINS = _OF_LINES | {"MSG002", "MSG004"}
"""Rules that tell of nothing behind a spin that returns by an exception alone."""


def without_second_lines(index: WorkspaceIndex, findings: Iterable[Finding]) -> list[Finding]:
    """The findings but for those about what no run comes to, as another of them says that a line before it always
    fails: how a program ends behind that line, and what is wrong in a function that is called there alone."""
    every = list(findings)
    failing = {finding.place for finding in every if finding.fails}
    behind = BehindFailures(index, failing)
    judged = [
        finding for finding in every if not (_is_of_failing_call(finding, failing) or _is_second(finding, behind))
    ]
    return [each for each in judged if each.code not in _BEHIND_SPINS or not is_behind_a_spin(index, each.place)]


def _is_of_failing_call(finding: Finding, failing: Set[Place]) -> bool:
    """Whether a finding tells what a call does that raises an exception instead."""
    return finding.code.startswith(_OF_CALLS) and not finding.fails and finding.place in failing


def _is_second(finding: Finding, behind: BehindFailures) -> bool:
    if finding.code in _AT_THE_END:
        return behind.skips(finding.place)
    if PAST_HANDLER in finding.group:
        return behind.skips(finding.place) or any(behind.is_never_left(other.place) for other in finding.related)
    return finding.code in _OF_LINES and behind.leaves_out(finding.place)


__all__ = ["without_second_lines"]
