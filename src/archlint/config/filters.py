"""What the configuration does to a finding: keep it, drop it, or change its severity."""

from __future__ import annotations

from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.config.presets import PRESETS
from archlint.config.selection import NEVER_OFF
from archlint.rulebook import codes_of

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.finding import Finding, Severity
    from archlint.workspace.model import Workspace


class Filters:
    """``ignore``, ``per-file-ignores``, ``per-package-ignores`` and ``severity``, for one workspace.

    What lies in files that were only read as context is dropped, too, unless it is about a connection whose other
    end was asked for, or a broken module that is imported there.
    """

    def __init__(self, settings: Settings, workspace: Workspace) -> None:
        self._selection = settings.selection
        self._by_file = [(glob, _codes(selectors)) for glob, selectors in settings.per_file_ignores.items()]
        self._by_package = [(name, _codes(selectors)) for name, selectors in settings.per_package_ignores.items()]
        self._severities = _severities(settings)
        self._preset = PRESETS[settings.preset]
        self._files = {file.relative: file for file in workspace.files}

    def apply(self, finding: Finding) -> Finding | None:
        """The finding as it is to be shown; None where it is not wanted."""
        if finding.code != NEVER_OFF and self._drops(finding):
            return None
        severity = self._severities.get(finding.code, self._preset.severity(finding))
        return finding if severity == finding.severity else replace(finding, severity=severity)

    def _drops(self, finding: Finding) -> bool:
        file = self._files.get(finding.place.file)
        if not self._selection.runs(finding.code, closed=True) or not self._asked_for(finding):
            return True
        if any(finding.code in codes and glob.matches(finding.place.file) for glob, codes in self._by_file):
            return True
        package = None if file is None else file.package
        return package is not None and any(
            finding.code in codes and fnmatchcase(package, pattern) for pattern, codes in self._by_package
        )

    def _asked_for(self, finding: Finding) -> bool:
        """Whether the place of a finding was asked for, or one of those that a connection has elsewhere."""
        places = [finding.place.file]
        if finding.code.startswith(_OF_CONNECTIONS):
            places += (related.place.file for related in finding.related)
        return any((file := self._files.get(place)) is None or not file.context for place in places)


_OF_CONNECTIONS = (
    "ACT002",
    "ARC",
    "LNT002",
    "NME004",
    "OWN",
    "QOS001",
    "QOS002",
    "QOS003",
    "SRV002",
    "SRV006",
    "TOP001",
    "TOP004",
)
"""Rules about two ends, of which either may be the place of the finding: a module and its import are such, too."""


def _codes(selectors: tuple[str, ...]) -> set[str]:
    return {code for selector in selectors for code in codes_of(selector)}


def _severities(settings: Settings) -> dict[str, Severity]:
    """Severity by code; the more specific selector wins."""
    severities: dict[str, Severity] = {}
    for selector, severity in sorted(settings.severity.items(), key=lambda entry: -len(codes_of(entry[0]))):
        severities.update(dict.fromkeys(codes_of(selector), severity))
    return severities
