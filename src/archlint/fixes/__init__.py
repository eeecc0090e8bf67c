"""Fixes: edits that mend a finding, made from the text of the file and applied all or not at all."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.fixes import names, timeouts
from archlint.fixes.source import Source, read

if TYPE_CHECKING:
    from archlint.finding import Finding, Fix

Builder = Callable[["Finding", Source, "Surroundings"], "Fix | None"]

BUILDERS: dict[str, Builder] = {
    "NME001": lambda finding, source, _: names.declare_parameter(finding, source),
    "TMO001": lambda finding, source, _: timeouts.limit_wait(finding, source),
    "TMO002": lambda finding, source, around: timeouts.limit_call(finding, source, around.distros),
    "TMO003": lambda finding, source, _: timeouts.limit_spin(finding, source),
}
"""By the code of the rule; the fixes of LNT001 and PKG001 come with the findings."""


class Surroundings:
    """What a fix may need beside its finding: the texts of files, each read once, and ``distros``, the ROS
    distributions that the code is for."""

    def __init__(self, distros: tuple[str, ...]) -> None:
        self.distros: tuple[str, ...] = distros
        self._sources: dict[str, Source | None] = {}

    def source(self, file: str) -> Source | None:
        if file not in self._sources:
            self._sources[file] = read(file)
        return self._sources[file]


def attach(findings: Iterable[Finding], around: Surroundings) -> list[Finding]:
    """The findings, each with its fix where there is one."""
    return [_with_fix(finding, around) for finding in findings]


def _with_fix(finding: Finding, around: Surroundings) -> Finding:
    builder = BUILDERS.get(finding.code)
    if builder is None or finding.fix is not None:
        return finding
    source = around.source(finding.place.file)
    fix = None if source is None else builder(finding, source, around)
    return finding if fix is None else replace(finding, fix=fix)
