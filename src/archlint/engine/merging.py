"""One finding for what several systems show, and one for several findings with one cause."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from archlint.checks.registry import registered, registered_folds
from archlint.finding import Finding


def merged(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings without repetitions; those of the open system come first and stay."""
    seen: dict[tuple[object, ...], tuple[str | None, str | None]] = {}
    for finding in sorted(findings, key=lambda finding: (finding.system is not None, finding.condition is not None)):
        keys = _keys(finding)
        own = finding.system, finding.condition
        # Two findings of one system differ for a reason: only what another system has said is a repetition, or the
        # same one under any arguments.
        said = {seen.get(key, own) for key in keys}
        if all(system == finding.system and (condition or not finding.condition) for system, condition in said):
            yield _with_condition(finding)
        for key in keys:
            seen.setdefault(key, own)


def _with_condition(finding: Finding) -> Finding:
    """The finding with the arguments under which it holds in its message."""
    if finding.condition is None:
        return finding
    return replace(finding, message=f"{finding.message} (with {finding.condition})")


def _keys(finding: Finding) -> set[tuple[object, ...]]:
    """What another finding has in common with this one if both are one, as the scope of the rule says."""
    keys: set[tuple[object, ...]] = {(finding.code, finding.place, finding.message)}
    check = registered().get(finding.code)
    places = tuple(related.place for related in finding.related)
    if check is None or check.scope.once_a_place:
        keys.add((finding.code, finding.place))
    elif places:
        keys.add((finding.code, finding.place, places))
    return keys


def folded(findings: Iterable[Finding], *, in_a_part: bool = False) -> list[Finding]:
    """The findings with those of one group made one, which no longer has a group: once each had its chance to be
    turned off.  ``in_a_part`` leaves those that other workspaces may show as well."""
    folds = registered_folds()
    alone: list[Finding] = []
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for finding in findings:
        fold = folds.get(finding.code)
        if fold is not None and finding.group and in_a_part and fold.across_workspaces:
            alone.append(finding)
        elif fold is not None and finding.group:
            system = None if fold.across_systems else (finding.system, finding.condition)
            severity = None if fold.across_severities else finding.severity
            groups.setdefault((finding.code, severity, system, *finding.group[: fold.common]), []).append(finding)
        else:
            alone.append(finding)
    for several in groups.values():
        ordered = sorted(several, key=lambda finding: finding.sort_key)
        alone.extend(replace(each, group=()) for each in folds[ordered[0].code].each(ordered))
    return alone
