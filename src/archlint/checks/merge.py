"""One finding for what several systems show: the same code at the same place about the same thing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from archlint.finding import Finding


def merged(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings without repetitions; those of the open system come first and stay."""
    seen: set[tuple[object, ...]] = set()
    for finding in sorted(findings, key=lambda one: one.system is not None):
        places = tuple(related.place for related in finding.related)
        keys = {
            (finding.code, finding.place, finding.message),
            (finding.code, finding.place, places, finding.message if not places else ""),
        }
        if seen.isdisjoint(keys):
            yield finding
        seen |= keys
