"""Findings about lines of code to which no program here comes: nobody meets them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.analysis.reached_code import is_unreached
from archlint.engine.second_lines import without_second_lines

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex

_OF_RUNS = ("ACT", "API", "CBG", "EXE", "MSG", "SRV", "TMO")
"""Families of rules that tell what happens as a line runs."""
_WEIGHS_ITSELF = "TMO002"
"""A rule that has an option for functions that nothing calls."""


def of_lines_that_run(index: WorkspaceIndex, findings: Iterable[Finding]) -> list[Finding]:
    """The findings but for those that tell what happens as a line runs to which no program comes, or none comes because
    a line before it fails."""
    met = without_second_lines(index, findings)
    return [each for each in met if not (_is_of_runs(each.code) and is_unreached(index, each.place))]


def _is_of_runs(code: str) -> bool:
    return code.startswith(_OF_RUNS) and code != _WEIGHS_ITSELF


__all__ = ["of_lines_that_run"]
