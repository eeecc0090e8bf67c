"""Findings as diagnostics of the protocol."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from lsprotocol.types import (
    CodeDescription,
    Diagnostic,
    DiagnosticRelatedInformation,
    DiagnosticSeverity,
    DiagnosticTag,
    Location,
)

from archlint.finding import Finding, Severity
from archlint.project import REPOSITORY, is_placeholder
from archlint.records import dataclass
from archlint.rulebook import pages_folder
from archlint.server.positions import Positions, Units
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.live.snapshot import Snapshot
    from archlint.server.uris import Addresses

SOURCE = "archlint"

_SEVERITIES: Mapping[Severity, DiagnosticSeverity] = {
    Severity.ERROR: DiagnosticSeverity.Error,
    Severity.WARNING: DiagnosticSeverity.Warning,
    Severity.INFO: DiagnosticSeverity.Information,
}
_UNNECESSARY = frozenset({"LNT001"})
"""Findings about text that does nothing: editors show it faded."""


@dataclass
class Shown:
    """A snapshot as an editor wants it: its addresses, its way to count."""

    snapshot: Snapshot
    addresses: Addresses
    units: Units
    _positions: dict[str, Positions] = field(default_factory=dict)

    def positions(self, file: str) -> Positions:
        """The positions of a file, by its shown path."""
        if file not in self._positions:
            self._positions[file] = Positions(self.snapshot.text(file) or "", self.units)
        return self._positions[file]

    def address(self, file: str) -> str:
        return self.addresses.of(self.snapshot.path(file))

    def diagnostics(self, findings: Iterable[Finding]) -> list[Diagnostic]:
        return [self.diagnostic(finding) for finding in findings]

    def diagnostic(self, finding: Finding) -> Diagnostic:
        """A finding, whose message ends in its advice."""
        advice = f"\nhelp: {visible(finding.help)}" if finding.help else ""
        return Diagnostic(
            range=self.positions(finding.place.file).range(finding.place),
            message=visible(finding.message) + advice,
            severity=_SEVERITIES[finding.severity],
            code=finding.code,
            code_description=CodeDescription(page_address(finding)),
            source=SOURCE,
            tags=[DiagnosticTag.Unnecessary] if finding.code in _UNNECESSARY else None,
            related_information=[
                DiagnosticRelatedInformation(
                    Location(self.address(related.place.file), self.positions(related.place.file).range(related.place)),
                    visible(related.message),
                )
                for related in finding.related
            ],
        )


def page_address(finding: Finding) -> str:
    """Where the page of a finding's rule can be read: on the network once archlint has a place there, else where it is
    installed."""
    page = f"{finding.code}-{finding.name}.md"
    if is_placeholder(REPOSITORY):
        return (pages_folder() / page).as_uri()
    return f"{REPOSITORY}/blob/main/rules/{page}"


def by_path(snapshot: Snapshot) -> dict[str, list[Finding]]:
    """The findings of a snapshot by the absolute paths of their files."""
    rows: dict[str, list[Finding]] = {}
    for finding in snapshot.findings:
        rows.setdefault(snapshot.path(finding.place.file), []).append(finding)
    return rows


__all__ = ["SOURCE", "Shown", "by_path", "page_address"]
