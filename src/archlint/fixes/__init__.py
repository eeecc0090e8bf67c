"""Fixes: edits that mend a finding, made at the sites that its rule knows and applied all or not at all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.faults import Faults
from archlint.fixes.dependencies import declared
from archlint.fixes.limits import limited
from archlint.fixes.names import Names
from archlint.fixes.suppressions import shortened
from archlint.fixes.surroundings import Surroundings

if TYPE_CHECKING:
    from archlint.edit_sites import Sites
    from archlint.finding import Finding, Fix


def attach(findings: Iterable[Finding], around: Surroundings, faults: Faults | None = None) -> list[Finding]:
    """The findings, each with its fix where there is one.  A fix that fails to be made is noted in ``faults``."""
    mended = list(findings)
    faults = faults or Faults()
    names = Names((call for finding in mended if finding.sites for call in finding.sites.names), around)
    for number, finding in enumerate(mended):
        with faults.contained(f"making the fix of {finding.code}", finding.place):
            fix = _fix(finding, around, names)
            mended[number] = finding if fix is None else replace(finding, fix=fix)
    return mended


def _fix(finding: Finding, around: Surroundings, names: Names) -> Fix | None:
    sites = finding.sites
    if sites is None:
        return None
    if sites.names:
        return names.fix(sites.names)
    fixes = [fix for fix in _fixes_of_files(sites, around) if fix is not None]
    return replace(fixes[0], edits=tuple(edit for fix in fixes for edit in fix.edits)) if fixes else None


def _fixes_of_files(sites: Sites, around: Surroundings) -> Iterator[Fix | None]:
    """A fix for each file that a finding would have edited."""
    for missing in sites.dependencies:
        manifest = around.source(missing.manifest)
        yield None if manifest is None else declared(missing, manifest)
    for idle in sites.suppressions:
        source = around.source(idle.comment.file)
        yield None if source is None else shortened(idle, source)
    for file in dict.fromkeys(call.arguments.file for call in sites.limits):
        source = around.source(file)
        yield None if source is None else limited([c for c in sites.limits if c.arguments.file == file], source)


__all__ = ["Surroundings", "attach"]
