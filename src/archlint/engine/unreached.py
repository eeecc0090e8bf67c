"""Findings about lines of code to which no program comes: they are counted and not shown, as nobody meets them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.analysis.reached_code import is_unreached

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex

_OF_RUNS = ("ACT", "API", "CBG", "EXE", "MSG", "SRV", "TMO")
"""Families of rules that tell what happens as a line runs."""
_WEIGHS_ITSELF = "TMO002"
"""A rule that has an option for functions that nothing calls."""


def without_unreached(
    index: WorkspaceIndex, findings: Iterable[Finding], request: Request
) -> tuple[list[Finding], list[Finding]]:
    """The findings but for those that tell what happens as a line runs to which no program comes, and these; all where
    the settings want all files shown."""
    if request.settings.unused_files:
        return list(findings), []
    met: list[Finding] = []
    unmet: list[Finding] = []
    for each in findings:
        (unmet if _is_of_runs(each.code) and is_unreached(index, each.place) else met).append(each)
    return met, unmet


def _is_of_runs(code: str) -> bool:
    return code.startswith(_OF_RUNS) and code != _WEIGHS_ITSELF


__all__ = ["without_unreached"]
