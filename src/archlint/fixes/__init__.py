"""Fixes: edits that mend a finding, made at the sites that its rule knows and applied all or not at all."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.faults import Faults
from archlint.fixes.dependencies import declared
from archlint.fixes.limits import limited
from archlint.fixes.names import Names
from archlint.fixes.suppressions import shortened
from archlint.fixes.surroundings import Surroundings

if TYPE_CHECKING:
    from archlint.finding import Finding, Fix


def attach(findings: Iterable[Finding], around: Surroundings, faults: Faults | None = None) -> list[Finding]:
    """The findings, each with its fix where there is one.  Of a fix that fails to be made, ``faults`` are told."""
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
    source = around.source(finding.place.file if sites.dependencies is None else sites.dependencies.manifest)
    if source is None:
        return None
    if sites.dependencies is not None:
        return declared(sites.dependencies, source)
    if sites.suppression is not None:
        return shortened(sites.suppression, source)
    return limited(sites.limits, source)


__all__ = ["Surroundings", "attach"]
