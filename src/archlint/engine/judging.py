"""What the selected rules find in a system, and under which launch arguments."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside, is_disused
from archlint.checks.registry import Check, Options, failure, registered
from archlint.faults import Fault
from archlint.finding import Finding, Place
from archlint.monitor import Monitor
from archlint.rulebook import rules
from archlint.suggestions import limited_suggestions
from archlint.systems.variants import Arguments, condition

if TYPE_CHECKING:
    from archlint.systems.model import System

_NOBODY = Monitor()


def judge(system: System, selected: Mapping[str, Options], monitor: Monitor = _NOBODY) -> Iterator[Finding]:
    """What the selected rules find in a system; a rule that raises becomes an LNT003 finding."""
    for code, check in registered().items():
        if code not in selected:
            continue
        monitor.asking()
        try:
            with limited_suggestions():
                findings = list(check.function(system, selected[code]))
        except Exception as error:
            page = rules()[code]
            yield failure(Fault.of(f"the rule {page.title}", error, _place_of(system)), page.plugin)
        else:
            kept = [finding for finding in findings if not _passes_by(check, system, finding.place.file)]
            yield from (replace(finding, system=system.name) for finding in kept)


def _passes_by(check: Check, system: System, file: str) -> bool:
    if check.taste:
        return is_aside(system.workspace, file)
    return check.in_use and is_disused(system.workspace, file)


def judge_alternatives(
    system: System, selected: Mapping[str, Options], monitor: Monitor = _NOBODY
) -> Iterator[Finding]:
    """As :func:`judge`; where arguments that nothing decides, or that have choices, make several systems of one launch
    file, each is judged, and a finding says under which arguments it holds.  Of choices, only what the defaults do not
    show at the same place is reported."""
    if not system.alternatives:
        yield from judge(system, selected, monitor)
        return
    checks = registered()
    split = {c: options for c, options in selected.items() if c in checks and checks[c].scope.of_each_arguments}
    rest = {code: options for code, options in selected.items() if code not in split}
    yield from judge(system, rest, monitor)
    every = [arguments for arguments, _ in system.alternatives]
    holding: dict[tuple[object, ...], tuple[Finding, list[Arguments]]] = {}
    for arguments, alternative in system.alternatives:
        for finding in judge(alternative, split, monitor):
            key = (finding.code, finding.place, finding.message, finding.node, finding.related)
            holding.setdefault(key, (finding, []))[1].append(arguments)
    at_place: dict[tuple[object, ...], list[Finding]] = {}
    for finding, where in holding.values():
        by_default = system.defaults_decide and every[0] in where
        conditional = replace(finding, condition=None if by_default else condition(where, every))
        at_place.setdefault((finding.code, finding.place), []).append(conditional)
    for several in at_place.values():
        unconditional = [finding for finding in several if finding.condition is None] if system.defaults_decide else []
        yield from unconditional or (several if len(several) <= _VARIANTS else [min(several, key=_how_general)])


_VARIANTS = 2
"""So many findings of one rule at one place are two mistakes; more are one, in the combinations of arguments."""


def _how_general(finding: Finding) -> tuple[int, int, str]:
    """Least for what holds with the fewest arguments, and then for what names most places."""
    return ((finding.condition or "").count(":="), -len(finding.related), finding.message)


def _place_of(system: System) -> Place:
    """Where to show that a system could not be judged: its launch file, or the first file of a node."""
    places = [node.blueprint.place.file for node in system.nodes if node.blueprint is not None]
    file = system.name or min(places, default=".")
    return Place(file, 1, 1, 1, 1)
