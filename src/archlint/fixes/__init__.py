"""Fixes: edits that mend a finding, made from the text of the file and applied all or not at all."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.faults import Faults
from archlint.fixes import names, timeouts
from archlint.fixes.source import Source
from archlint.fixes.surroundings import Surroundings

if TYPE_CHECKING:
    from archlint.finding import Finding, Fix

Builder = Callable[["Finding", Source, Surroundings], "Fix | None"]

BUILDERS: dict[str, Builder] = {
    "NME001": lambda finding, _, around: names.declare_parameter(finding, around),
    "TMO001": lambda finding, source, _: timeouts.limit_wait(finding, source),
    "TMO002": lambda finding, source, around: timeouts.limit_call(finding, source, around.distros),
    "TMO003": lambda finding, source, _: timeouts.limit_spin(finding, source),
}
"""By the code of the rule; the fixes of LNT001 and PKG001 come with the findings."""


def attach(findings: Iterable[Finding], around: Surroundings, faults: Faults | None = None) -> list[Finding]:
    """The findings, each with its fix where there is one.  Of a fix that fails to be made, ``faults`` are told."""
    found = list(findings)
    around.keep(found)
    faults = faults or Faults()
    for number, finding in enumerate(found):
        with faults.contained(f"making the fix of {finding.code}", finding.place):
            found[number] = _with_fix(finding, around)
    return found


def _with_fix(finding: Finding, around: Surroundings) -> Finding:
    builder = BUILDERS.get(finding.code)
    if builder is None or finding.fix is not None or not finding.mendable:
        return finding
    source = around.source(finding.place.file)
    fix = None if source is None else builder(finding, source, around)
    return finding if fix is None else replace(finding, fix=fix)


__all__ = ["BUILDERS", "Surroundings", "attach"]
