"""One cause, one finding: findings that share a cause become one, once each had its chance to be turned off.

A rule that finds the same mistake at several places yields a finding for each, all with the same ``group``.  What
the user suppresses or ignores at one place leaves the others; the rest becomes one finding, with one fix.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from archlint.finding import Finding

Fold = Callable[[Sequence[Finding]], Finding]

_FOLDS: dict[str, Fold] = {}
_ACROSS_SYSTEMS: set[str] = set()


def folds(code: str, *, across_systems: bool = False) -> Callable[[Fold], Fold]:
    """Register the decorated function as what makes one finding of several of the rule with this code: they come in
    the order of their places.  ``across_systems`` also folds what several launch files show."""

    def register(function: Fold) -> Fold:
        _FOLDS[code] = function
        if across_systems:
            _ACROSS_SYSTEMS.add(code)
        return function

    return register


def folded(findings: Iterable[Finding]) -> list[Finding]:
    """The findings with those of one group made one, which no longer has a group."""
    alone: list[Finding] = []
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for one in findings:
        if one.group and one.code in _FOLDS:
            system = None if one.code in _ACROSS_SYSTEMS else (one.system, one.condition)
            groups.setdefault((one.code, one.severity, system, *one.group), []).append(one)
        else:
            alone.append(one)
    for several in groups.values():
        ordered = sorted(several, key=lambda one: one.sort_key)
        found = ordered[0] if len(ordered) == 1 else _FOLDS[ordered[0].code](ordered)
        alone.append(replace(found, group=()))
    return alone
